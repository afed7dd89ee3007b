// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/render/files.h"

#include <unistd.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkXMLPolyDataWriter.h>

#include <system_error>
#include <utility>

#include "base/files/write_file.h"
#include "base/invalid_input.h"

namespace powderlink::render {
namespace fs = std::filesystem;
namespace {

[[noreturn]] void cannot_write(const fs::path& path, const std::string& reason) {
  throw InvalidInput("writing " + path.string(), reason,
                     "a folder that exists, may be written to and has space left",
                     "check the folder, its rights and `df -h`");
}

fs::path beside(const fs::path& path) {
  fs::path name = "." + path.filename().string() + ".part" + std::to_string(getpid());
  return path.parent_path() / name;
}

}  // namespace

void write_vtp(const fs::path& path, vtkPolyData* data) {
  vtkNew<vtkXMLPolyDataWriter> writer;
  writer->SetInputData(data);
  writer->SetDataModeToBinary();
  writer->WriteToOutputStringOn();
  if (writer->Write() == 0) cannot_write(path, "VTK could not encode the data");
  write_file(path, writer->GetOutputString());
}

StagedFolder::StagedFolder(fs::path final_path)
    : final_(std::move(final_path)), staging_(beside(final_)) {
  std::error_code error;
  fs::remove_all(staging_, error);
  fs::create_directory(staging_, error);
  if (error) cannot_write(final_, error.message());
}

StagedFolder::~StagedFolder() {
  std::error_code ignored;
  if (!staging_.empty()) fs::remove_all(staging_, ignored);
}

void StagedFolder::publish() {
  const fs::path old = final_.parent_path() / ("." + final_.filename().string() + ".old");
  std::error_code error;
  fs::remove_all(old, error);
  if (fs::exists(final_)) fs::rename(final_, old, error);
  if (!error) fs::rename(staging_, final_, error);
  if (error) cannot_write(final_, error.message());
  staging_.clear();
  fs::remove_all(old, error);
}

}  // namespace powderlink::render
