// SPDX-License-Identifier: GPL-3.0-or-later
/// \file particle_clock.h
/// Times of the particles' dumps on the clock of the gas [s], for every reader of dumps.
///
///   t_gas = t_particles - ahead,    t_particles = the dump's own time, else step dt
///
/// `ahead` is what LIGGGHTS's clock had before the first exchange (a bed that settled). powderFoam
/// writes it with its fields, <T>/uniform/couplingClock; where it differs from one time folder to
/// another (a coupled run that was begun anew in the same folder), a dump takes that of the first
/// folder which is not before it, since this is the run that it belongs to; after the last folder
/// the last one counts. Without such a file the clocks are taken as one.
/// Tests: tests/analysis/flow/particle_clock_test.cpp
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "analysis/flow/run/particle_dump.h"

namespace powderlink::analysis {

/// Clock of the particles minus that of the fields, as written in ROOT/<name>/uniform of each time
/// folder; names without the file are left out. One call of powderlink-foam for all.
struct WrittenClock {
  std::optional<double> time_s;  ///< exact; the folder's name may be rounded
  double particles_ahead_s = 0.0;
  bool has_ahead = false;
  std::string files;  ///< of the checkpoint, besides the fields; with blanks between
};
std::map<std::string, WrittenClock> read_written_clocks(const std::filesystem::path& case_folder,
                                                        const std::filesystem::path& root,
                                                        const std::vector<std::string>& names);

class ParticleClock {
 public:
  /// \param time_step_s  of the DEM; empty: the case's own, looked for when a dump needs it
  ParticleClock(const std::filesystem::path& case_folder, std::optional<double> time_step_s);

  double gas_time_s(const DumpState& state);
  double gas_time_s(long step);

  /// Whether some time folder says how far the particles are ahead.
  bool known() const { return !ahead_.empty(); }

 private:
  double on_gas_clock(double particles_s) const;

  std::filesystem::path folder_;
  std::optional<double> given_step_s_, step_s_;
  std::map<double, double> ahead_;  ///< by the particles' time of a time folder
};

}  // namespace powderlink::analysis
