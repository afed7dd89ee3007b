// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/laboratory/grain_files.h"

#include <algorithm>
#include <boost/algorithm/string/case_conv.hpp>

#include "analysis/particles/particle_table.h"
#include "models/invalid_input.h"

namespace powderlink::analysis {

namespace fs = std::filesystem;

double GrainDiameters::ratio_of_files() const {
  return static_cast<double>(after_files.size()) / static_cast<double>(before_files.size());
}

namespace {

void refuse_images(const std::vector<fs::path>& files) {
  for (const fs::path& file : files) {
    std::string kind = file.extension().string();
    boost::algorithm::to_lower(kind);
    for (const char* image : {".png", ".tif", ".tiff", ".jpg", ".jpeg", ".bmp"}) {
      if (kind != image) continue;
      throw InvalidInput(
          "grains before and after the drop", file.string() + ", a picture",
          "tables of grains with Area and Perim.",
          "measure the grains first, by powderlink psd or in Fiji, and give its table");
    }
  }
}

}  // namespace

GrainDiameters read_grains(const GrainFiles& given) {
  std::vector<fs::path> files = expand_patterns(given.before);
  const std::size_t before = files.size();
  for (const fs::path& file : expand_patterns(given.after)) {
    if (std::find(files.begin(), files.end(), file) != files.end()) {
      throw InvalidInput("files before and after the drop", file.string() + " in both",
                         "every file in one of them", "correct --before or --after");
    }
    files.push_back(file);
  }
  refuse_images(files);
  const ParticleSet set = read_particle_tables(files, given.pixel_size_um);
  GrainDiameters d;
  d.pixel_size_um = set.pixel_size_um;
  d.notes = set.notes;
  for (std::size_t i = 0; i < files.size(); ++i)
    (i < before ? d.before_files : d.after_files).push_back(set.files[i]);
  for (const Particle& p : set.particles) {
    (p.file < before ? d.before_um : d.after_um)
        .push_back(given.by_perimeter ? p.perimeter_diameter_um() : p.area_diameter_um());
  }
  return d;
}

}  // namespace powderlink::analysis
