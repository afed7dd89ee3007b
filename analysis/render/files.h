// SPDX-License-Identifier: GPL-3.0-or-later
/// \file files.h
/// Results appear whole or not at all: everything is written beside its place and then renamed.
/// Tests: tests/analysis/render/series_test.cpp, tests/analysis/render/bad_input_test.cpp
#pragma once

#include <filesystem>

class vtkPolyData;

namespace powderlink::render {

/// Writes a binary .vtp that ParaView opens.
void write_vtp(const std::filesystem::path& path, vtkPolyData* data);

/// A folder that takes its final name only by publish(); otherwise it vanishes with its contents.
class StagedFolder {
 public:
  explicit StagedFolder(std::filesystem::path final_path);
  ~StagedFolder();
  StagedFolder(const StagedFolder&) = delete;
  StagedFolder& operator=(const StagedFolder&) = delete;

  const std::filesystem::path& path() const { return staging_; }
  /// Replaces what had the final name before.
  void publish();

 private:
  std::filesystem::path final_, staging_;
};

}  // namespace powderlink::render
