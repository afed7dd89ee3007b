// SPDX-License-Identifier: GPL-3.0-or-later
#include "liggghts_styles/couple_bridge/leaving_particles.h"

#include <cstddef>

namespace powderlink::host {

bool LeavingParticles::collect(MPI_Comm world) {
  int ranks = 1;
  MPI_Comm_size(world, &ranks);
  const int count = static_cast<int>(left_.size()) * kDoubles;
  std::vector<int> counts(static_cast<std::size_t>(ranks)), starts(counts.size());
  MPI_Allgather(&count, 1, MPI_INT, counts.data(), 1, MPI_INT, world);
  int size = 0;
  for (std::size_t r = 0; r < counts.size(); ++r) {
    starts[r] = size;
    size += counts[r];
  }
  if (size == 0) return false;
  std::vector<VanishedParticle> all(static_cast<std::size_t>(size / kDoubles));
  MPI_Allgatherv(left_.data(), count, MPI_DOUBLE, all.data(), counts.data(), starts.data(),
                 MPI_DOUBLE, world);
  left_.clear();
  // From rank to rank and then away: what it took is complete where it left last.
  for (const VanishedParticle& particle : all) {
    const std::pair<double, bool> key(particle.id, particle.borrowed != 0.0);
    const auto [entry, is_new] = departures_.try_emplace(key);
    VanishedParticle& newest = entry->second.newest;
    if (is_new || newest.step < particle.step) newest = particle;
  }
  return true;
}

void LeavingParticles::see(double id, bool borrowed) {
  const auto found = departures_.find({id, borrowed});
  if (found != departures_.end()) found->second.seen = 1;
}

std::vector<VanishedParticle> LeavingParticles::vanished(MPI_Comm world) {
  std::vector<int> seen;
  for (const auto& [key, departure] : departures_) seen.push_back(departure.seen);
  MPI_Allreduce(MPI_IN_PLACE, seen.data(), static_cast<int>(seen.size()), MPI_INT, MPI_MAX, world);
  std::vector<VanishedParticle> gone;
  std::size_t n = 0;
  for (const auto& [key, departure] : departures_) {
    if (seen[n++] == 0) gone.push_back(departure.newest);
  }
  departures_.clear();
  return gone;
}

}  // namespace powderlink::host
