// SPDX-License-Identifier: GPL-3.0-or-later
/// \file leaving_particles.h
/// Particles that left a rank between two exchanges: which of them have vanished (deleted, lost), with
/// the impulse that the fluid gave them until then. The others have moved to another rank.
///
///   leaving.note(particle);                 // whenever LIGGGHTS removes one from this rank
///   if (leaving.collect(world)) {           // at the exchange
///     for each particle of this rank: leaving.see(id, borrowed);
///     gone = leaving.vanished(world);
///   }
///
/// Tags are used again: a particle is known by its id and by whether it came after the last exchange.
/// Tests: tests/liggghts_styles/couple_bridge_traffic_test.cpp
#pragma once

#include <map>
#include <utility>
#include <vector>

#include <mpi.h>

namespace powderlink::host {

/// Doubles only: it goes through MPI and into restart files as an array of them.
struct VanishedParticle {
  double id = 0.0;
  double borrowed = 0.0;       ///< 1: it came after the last exchange
  double step = 0.0;           ///< when it left the rank
  double place_m[3] = {};      ///< of the last exchange, or where it came
  double impulse_N_s[3] = {};  ///< of the reacting forces since the last exchange
};

class LeavingParticles {
 public:
  static constexpr int kDoubles = sizeof(VanishedParticle) / sizeof(double);

  void note(const VanishedParticle& particle) { left_.push_back(particle); }
  /// Collective: what all ranks noted, in one list and the same on all. False: nothing.
  bool collect(MPI_Comm world);
  /// A particle that this rank has.
  void see(double id, bool borrowed);
  /// Collective: those that no rank has; the same list on all ranks. Nothing is noted after it.
  std::vector<VanishedParticle> vanished(MPI_Comm world);

 private:
  struct Departure {
    VanishedParticle newest;
    int seen = 0;
  };
  std::vector<VanishedParticle> left_;
  std::map<std::pair<double, bool>, Departure> departures_;  ///< of all ranks
};

}  // namespace powderlink::host
