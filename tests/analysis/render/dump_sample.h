// SPDX-License-Identifier: GPL-3.0-or-later
/// \file dump_sample.h
/// A small drop test as LIGGGHTS dumps it: arrays id, type, v, f, radius, f_kat[1-3].
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace powderlink::render::test {

/// A folder that is empty at first and gone afterwards.
class TemporaryFolder {
 public:
  TemporaryFolder();
  ~TemporaryFolder();
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

struct SampleGrain {
  double x_m = 0.0, y_m = 0.0, z_m = 0.0, radius_m = 0.0, speed_m_s = 0.0;
  bool attached = true;
};

/// How the dump looks; LIGGGHTS joins three columns of a fix, but not one or two.
struct DumpStyle {
  bool joined = true, with_fix = true, with_velocity = true, with_force = true;
};

void write_dump(const std::filesystem::path& file, const std::vector<SampleGrain>& grains,
                const DumpStyle& style = {});

/// Grid of grains, 20 to 100 um; those above 46 um leave at step 100 and later.
std::vector<SampleGrain> sample_grains(long step);

constexpr double kTimeStep = 1e-7;

/// Steps 0, 100, ... 400 and kat_results.json.
void write_run(const std::filesystem::path& run);

std::string text_of(const std::filesystem::path& file);

/// All names below a folder, hidden ones included.
std::vector<std::string> names_below(const std::filesystem::path& folder);

}  // namespace powderlink::render::test
