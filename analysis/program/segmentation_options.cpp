// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/program/segmentation_options.h"

#include <fmt/format.h>
#include <unistd.h>

#include <cstdio>
#include <map>

#include "base/invalid_input.h"

namespace powderlink::analysis {

void add_segmentation_options(CLI::App& c, SegmentationOptions& o) {
  static const std::map<std::string, GrainTone> tones = {
      {"auto", GrainTone::automatic}, {"bright", GrainTone::bright}, {"dark", GrainTone::dark}};
  c.add_option("--grains", o.tone, "pictures: auto, bright or dark (default: auto)")
      ->transform(CLI::CheckedTransformer(tones));
  c.add_option("--threshold", o.level, "pictures: edge of grains, 0 background to 1 grains")
      ->capture_default_str();
  c.add_option("--min-pixels", o.least_px, "pictures: smallest diameter [pixels]")
      ->capture_default_str();
  c.add_option("--crop-bottom", o.crop_bottom, "pictures: height of a legend [pixels]")
      ->capture_default_str();
  c.add_flag("--no-split{false}", o.split, "pictures: keep touching grains together");
}

void check_segmentation_options(const SegmentationOptions& o) {
  if (!(o.level > 0.05 && o.level < 0.95)) {
    throw InvalidInput("option --threshold", number_text(o.level), "0.05 to 0.95",
                       "0.5 is the middle between background and grains");
  }
  if (!(o.least_px >= 3.0 && o.least_px <= 1000.0)) {
    throw InvalidInput("option --min-pixels", number_text(o.least_px), "3 to 1000 pixels",
                       "smaller ones are noise; 5 is usual");
  }
}

void show_pictures(std::size_t done, std::size_t all) {
  if (::isatty(STDERR_FILENO) == 0 || all < 2) return;
  fmt::print(stderr, "\rpowderlink: {} of {} pictures ", done, all);
  if (done == all) fmt::print(stderr, "\n");
}

}  // namespace powderlink::analysis
