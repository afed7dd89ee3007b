// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/sizes/pictures/grain_source.h"

#include <fmt/format.h>

#include <cmath>

#include "analysis/sizes/pictures/tiff_facts.h"
#include "base/invalid_input.h"

namespace powderlink::analysis {

namespace fs = std::filesystem;

namespace {

constexpr double kRounded = 2e-3;  // of a scale as people type it, relative

bool same_scale(double a, double b) { return std::fabs(a - b) <= kRounded * b; }

/// The one scale of all pictures: as given, else as the files say. Stacks are refused, as the same
/// grains at several depths or times would count several times.
std::optional<double> scale_of(const std::vector<fs::path>& pictures, std::optional<double> scale,
                               std::vector<std::string>& notes) {
  for (const fs::path& picture : pictures) {
    const TiffFacts facts = read_tiff_facts(picture);
    if (facts.pictures > 1) {
      throw InvalidInput(picture.string(), fmt::format("a stack of {} pictures", facts.pictures),
                         "one picture per file",
                         "in Fiji take Image > Stacks > Stack to Images "
                         "and save those that show different grains");
    }
    if (!facts.pixel_size_um) continue;
    const std::string where = picture.string() + ", scale of the TIFF";
    require_pixel_size_um(*facts.pixel_size_um, where);
    if (scale && !same_scale(*facts.pixel_size_um, *scale)) {
      throw InvalidInput(
          where, fmt::format("{:g} um per pixel", *facts.pixel_size_um),
          fmt::format("{:g} um, as given before: one pixel size in all files", *scale),
          "correct the wrong one: --pixel-size-um, or in Fiji Analyze > Set Scale");
    }
    if (!scale)
      notes.push_back(fmt::format("{}: {:g} um per pixel, as the TIFF says", picture.string(),
                                  *facts.pixel_size_um));
    if (!scale) scale = facts.pixel_size_um;
  }
  return scale;
}

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
  GrainSource source;
  std::vector<std::string> notes;
  const auto scale_um = scale_of(pictures, pixel_size_um, notes);
  if (!pictures.empty() && !scale_um) {
    throw InvalidInput(pictures.front().string() + ", pixel size", "a picture without a scale",
                       "the side of a pixel in um",
                       "give --pixel-size-um X, or save a TIFF with its scale in Fiji; "
                       "psd takes the scale bar too: --scale-bar-um L --scale-bar-px N");
  }
  source.set = read_particle_tables(tables, pixel_size_um);
  ParticleSet& set = source.set;
  set.notes.insert(set.notes.begin(), notes.begin(), notes.end());
  if (!pictures.empty() && set.pixel_size_um && !same_scale(*set.pixel_size_um, *scale_um)) {
    throw InvalidInput(
        pictures.front().string() + ", pixel size", fmt::format("{:g} um", *scale_um),
        fmt::format("{:g} um, as in the tables: one pixel size in all files", *set.pixel_size_um),
        "correct the wrong one, or analyse every magnification by itself");
  }
  if (!pictures.empty() && !set.pixel_size_um) set.pixel_size_um = scale_um;
  std::size_t done = 0;
  for (const fs::path& picture : pictures) {
    add_micrograph(picture, *scale_um, segmentation, source);
    if (progress) progress(++done, pictures.size());
  }
  return source;
}

}  // namespace powderlink::analysis
