// SPDX-License-Identifier: GPL-3.0-or-later
/// \file drop_run.h
/// One LIGGGHTS run of one drop in a folder of its own:
///   in.kat, log.liggghts, screen.txt, post/   as a user's own run would leave them
///   kat_results.json                          written by fix kat/drop at the end
///   finished                                  hash of script and program: the run is reused
/// Tests: tests/analysis/kat/kat_run_test.cpp
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "analysis/kat/dem/drop_script.h"

namespace powderlink::analysis {

struct DropParticle {
  double diameter_m = 0.0;
  bool attached = false;
  double speed_m_s = 0.0;
  double balance = 0.0;
};

struct DropResult {
  double largest_attached_m = 0.0;   ///< 0: all left
  double smallest_detached_m = 0.0;  ///< 0: all stayed
  std::vector<DropParticle> particles;
  bool reused = false;
  double wall_s = 0.0;

  bool bracketed() const { return largest_attached_m > 0.0 && smallest_detached_m > 0.0; }
};

struct DropRunner {
  std::filesystem::path program;  ///< liggghts-powderlink
  double wall_limit_s = 3600.0;
};

/// POWDERLINK_LIGGGHTS of the environment, else liggghts-powderlink beside this program.
/// Throws InvalidInput when it is not there.
std::filesystem::path find_liggghts();

/// Reuses a finished run of the same script. Throws InvalidInput with LIGGGHTS's own message.
DropResult run_drop(const DropRunner& runner, const DropScript& drop,
                    const std::filesystem::path& folder);

}  // namespace powderlink::analysis
