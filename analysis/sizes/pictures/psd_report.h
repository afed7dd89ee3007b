// SPDX-License-Identifier: GPL-3.0-or-later
/// \file psd_report.h
/// Everything that `powderlink psd` finds in tables and micrographs.
///
///   specks   d < Q1 (Q1/Q3)^6, Q1 and Q3 quartiles by mass, if these grains have 1 % of the mass at most
///
/// Specks have hardly any mass and are far below all the rest: dust or noise. They are flagged, and left
/// out on demand. Quartiles by mass do not depend on how many specks there are. A Rosin-Rammler powder
/// with n = 2 to 4 loses less than 1 % of its grains to the rule.
/// Tests: tests/analysis/sizes/psd_command_test.cpp
#pragma once

#include <array>
#include <limits>
#include <optional>

#include "analysis/sizes/particle_table.h"
#include "analysis/sizes/pictures/grain_source.h"
#include "analysis/sizes/rosin_rammler.h"
#include "base/statistics/bootstrap.h"

namespace powderlink::analysis {

enum class DiameterKind { area, perimeter };  ///< sqrt(4 A/pi) or 4 A/P

struct PsdOptions {
  std::optional<double> pixel_size_um;
  DiameterKind diameter = DiameterKind::area;
  double min_um = 0.0, max_um = std::numeric_limits<double>::infinity();  ///< others are left out
  bool drop_specks = false;
  Bootstrap bootstrap;
  SegmentationOptions segmentation;
};

struct Quantity95 {
  double value = 0.0;
  ConfidenceInterval interval;
};

struct PsdReport {
  PsdOptions options;
  ParticleSet set;          ///< after specks and cut-offs were left out
  std::vector<bool> speck;  ///< of set.particles
  std::size_t specks = 0;   ///< flagged, whether left out or not
  std::optional<SizeDistribution> number, mass;
  std::array<Quantity95, 3> by_number, by_mass;  ///< D10, D50, D90 [um]
  Quantity95 d50_other;                          ///< of the other equivalent diameter, by number
  std::array<Quantity95, 3> circularity, aspect_ratio;  ///< 10, 50 and 90 %
  std::size_t with_aspect_ratio = 0;
  std::optional<RosinRammlerFit> rr_number, rr_mass;          ///< whole
  std::optional<RosinRammlerFit> cut_number, cut_mass;        ///< between smallest and largest
  std::optional<RosinRammlerFit> foam_number, foam_mass;      ///< the same, from the smallest on
  std::vector<std::pair<std::string, std::string>> overlays;  ///< name of the file, PNG
};

double diameter_um(const Particle& particle, DiameterKind kind);

/// Reads and measures. Throws for the first file that cannot be used, and for fewer than 2 grains.
PsdReport analyse_sizes(const std::vector<std::filesystem::path>& files, const PsdOptions& options,
                        const PictureProgress& progress = {});

std::string psd_json(const PsdReport& report);

/// Name and content: particles.csv, distribution.csv, histogram.csv.
std::vector<std::pair<std::string, std::string>> psd_tables(const PsdReport& report);

}  // namespace powderlink::analysis
