// SPDX-License-Identifier: GPL-3.0-or-later
/// \file kat_results.h
/// The JSON file that `fix kat/drop ... results FILE` writes when the test is over: its one writer and its
/// one reader. Tests: tests/liggghts_styles/kat_drop/kat_results_test.cpp, tests/analysis/render/bad_input_test.cpp
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace powderlink::host {

/// One grain; plain doubles, because it travels through MPI as such.
struct KatGrainResult {
  double id;
  double diameter_m;
  double attached;  ///< 0 left, 1 in contact, 2 bound across the gap
  double speed_m_s;
  double energy_residual;
  double momentum_residual;
};

struct KatResults {
  double impact_velocity_m_s = 0.0;  ///< 0: not in the file, as for the next ones
  double critical_diameter_m = 0.0;  ///< 0: not bracketed
  double largest_attached_m = 0.0;   ///< 0: none
  double smallest_detached_m = 0.0;  ///< 0: none
  long out_of_order = 0;             ///< detached grains smaller than the largest attached one
  long steps = 0;
  long impact_step = 0;
  double time_step_s = 0.0;
  std::vector<KatGrainResult> grains;
};

/// Writes beside the file, then renames. Throws InvalidInput when the file cannot be written.
void write(const KatResults& results, const std::string& file);

/// What the file does not have is 0, and so are the residuals of the momentum where it has none. Throws
/// InvalidInput for what is no such file, and for sizes, speeds and times that are not above 0.
KatResults read_kat_results(const std::filesystem::path& file);

}  // namespace powderlink::host
