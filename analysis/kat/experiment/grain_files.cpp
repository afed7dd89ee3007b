// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/kat/experiment/grain_files.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "analysis/sizes/picture_names.h"
#include "analysis/sizes/table_doubts.h"
#include "base/files/file_patterns.h"
#include "base/invalid_input.h"

namespace powderlink::analysis {

namespace fs = std::filesystem;

double GrainDiameters::ratio_of_files() const {
  return static_cast<double>(after_files.size()) / static_cast<double>(before_files.size());
}

ParticleSet read_tables_of_grains(const std::vector<fs::path>& files,
                                  std::optional<double> pixel_size_um) {
  for (const fs::path& file : files) {
    if (!has_picture_suffix(file)) continue;
    throw InvalidInput(
        "grains before and after the drop", file.string() + ", a picture",
        "tables of grains with Area and Perim.",
        "measure the grains first, by powderlink psd or in Fiji, and give its table");
  }
  return read_particle_tables(files, pixel_size_um);
}

namespace {

/// Grains keep their shape in a drop: pictures of which one is lost in noise do not.
std::string shapes_differ(const std::vector<Particle>& before, const std::vector<Particle>& after) {
  constexpr double alike = 0.75;  // of the higher median circularity
  const double b = median_circularity(before), a = median_circularity(after);
  if (before.empty() || after.empty() || std::min(a, b) >= alike * std::max(a, b)) return "";
  return fmt::format(
      "the grains {} the drop have a median circularity of {:.2f}, those {} of {:.2f}: "
      "one of the two shows noise or clusters; d_c is not to be trusted. "
      "Look at their outlines, and take another threshold (Otsu for pictures with few grains)",
      a < b ? "after" : "before", std::min(a, b), a < b ? "before" : "after", std::max(a, b));
}

}  // namespace

GrainDiameters read_grains(const GrainFiles& given, const ParticleReader& reader) {
  const std::vector<fs::path> before = expand_patterns(given.before);
  std::vector<fs::path> files = before;
  std::set<fs::path> known;  // however they are spelled: ./a.csv is a.csv
  for (const fs::path& file : before) known.insert(fs::weakly_canonical(file));
  for (const fs::path& file : expand_patterns(given.after)) {
    if (known.count(fs::weakly_canonical(file)) > 0) {
      throw InvalidInput("files before and after the drop", file.string() + " in both",
                         "every file in one of them", "correct --before or --after");
    }
    files.push_back(file);
  }
  const ParticleSet set = reader(files, given.pixel_size_um);
  GrainDiameters d;
  d.pixel_size_um = set.pixel_size_um;
  d.notes = set.notes;
  if (given.by_perimeter)
    d.notes.insert(d.notes.end(), set.perimeter_notes.begin(), set.perimeter_notes.end());
  d.digits_um2 = digits_um2(set.area_step_um2, given.by_perimeter);
  std::vector<bool> is_before;  // a reader may change the order
  for (const std::string& file : set.files) {
    is_before.push_back(std::find(before.begin(), before.end(), fs::path(file)) != before.end());
    (is_before.back() ? d.before_files : d.after_files).push_back(file);
  }
  std::vector<Particle> before_grains, after_grains;
  for (const Particle& p : set.particles) {
    (is_before[p.file] ? d.before_um : d.after_um)
        .push_back(given.by_perimeter ? p.perimeter_diameter_um() : p.area_diameter_um());
    (is_before[p.file] ? before_grains : after_grains).push_back(p);
  }
  if (const std::string doubt = shapes_differ(before_grains, after_grains); !doubt.empty())
    d.notes.push_back(doubt);
  return d;
}

}  // namespace powderlink::analysis
