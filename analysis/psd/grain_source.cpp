// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/psd/grain_source.h"

#include <fmt/format.h>

#include "models/invalid_input.h"

namespace powderlink::analysis {

namespace fs = std::filesystem;

namespace {

/// Grains of one micrograph, with its overlay.
void add_micrograph(const fs::path& file, double pixel_size_um,
                    const SegmentationOptions& segmentation, GrainSource& source) {
  const Micrograph m = read_micrograph(file);
  const Segmentation found = segment(m, segmentation);
  ParticleSet& set = source.set;
  set.notes.insert(set.notes.end(), m.notes.begin(), m.notes.end());
  set.notes.push_back(fmt::format(
      "{}: {} whole grains; {} cut by the edge and {} smaller than {:g} pixels are left out",
      m.file, found.grains.size(), found.cut.size(), found.specks, segmentation.least_px));
  int number = 0;
  for (const GrainShape& g : found.grains) {
    Particle p;
    p.file = set.files.size();
    p.place = ++number;
    p.area_um2 = g.area_px * pixel_size_um * pixel_size_um;
    p.perimeter_um = g.perimeter_px * pixel_size_um;
    p.aspect_ratio = g.aspect_ratio;
    p.feret_um = g.feret_px * pixel_size_um;
    set.particles.push_back(p);
  }
  // The number keeps pictures of one name from different folders apart.
  source.overlays.emplace_back(
      fmt::format("overlay_{}_{}.png", source.overlays.size() + 1, file.stem().string()),
      overlay_png(m, found));
  set.files.push_back(file.string());
}

}  // namespace

GrainSource read_grain_source(const std::vector<fs::path>& files,
                              std::optional<double> pixel_size_um,
                              const SegmentationOptions& segmentation,
                              const PictureProgress& progress) {
  std::vector<fs::path> tables, pictures;
  for (const fs::path& file : files) (looks_like_picture(file) ? pictures : tables).push_back(file);
  if (!pictures.empty() && !pixel_size_um) {
    throw InvalidInput(pictures.front().string() + ", pixel size", "a picture without a scale",
                       "the side of a pixel in um",
                       "give --pixel-size-um X, or --scale-bar-um L and --scale-bar-px N");
  }
  GrainSource source;
  source.set = read_particle_tables(tables, pixel_size_um);
  if (!pictures.empty() && tables.empty()) source.set.pixel_size_um = pixel_size_um;
  std::size_t done = 0;
  for (const fs::path& picture : pictures) {
    add_micrograph(picture, *pixel_size_um, segmentation, source);
    if (progress) progress(++done, pictures.size());
  }
  return source;
}

}  // namespace powderlink::analysis
