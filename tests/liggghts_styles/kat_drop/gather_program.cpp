// SPDX-License-Identifier: GPL-3.0-or-later
// Run on any number of ranks: gather() must bring every grain to rank 0, ordered by id, unchanged.
#include <cstdio>
#include <vector>

#include <mpi.h>

#include "liggghts_styles/kat_drop/kat_gather.h"

using powderlink::host::KatGrainResult;

namespace {

KatGrainResult grain(int id) {
  return {double(id), 1e-5 + 1e-7 * id, double(id % 3), 0.1 * id, 1e-9 * id, -1e-9 * id};
}

bool same(const KatGrainResult& a, const KatGrainResult& b) {
  return a.id == b.id && a.diameter_m == b.diameter_m && a.attached == b.attached &&
         a.speed_m_s == b.speed_m_s && a.energy_residual == b.energy_residual &&
         a.momentum_residual == b.momentum_residual;
}

/// The ids of one rank, highest first; on request rank 0 of several has none.
std::vector<KatGrainResult> share(int rank, int ranks, int grains, bool empty_first_rank) {
  std::vector<KatGrainResult> mine;
  for (int id = grains; id >= 1; --id) {
    const int owner = empty_first_rank && ranks > 1 ? 1 + id % (ranks - 1) : id % ranks;
    if (owner == rank) mine.push_back(grain(id));
  }
  return mine;
}

}  // namespace

int main(int argc, char** argv) {
  MPI_Init(&argc, &argv);
  int rank = 0, ranks = 1;
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  MPI_Comm_size(MPI_COMM_WORLD, &ranks);
  int wrong = 0;
  for (const int grains : {0, 1, 17, 1000}) {
    for (const bool empty_first_rank : {false, true}) {
      const auto all =
          powderlink::host::gather(share(rank, ranks, grains, empty_first_rank), MPI_COMM_WORLD);
      if (rank != 0) {
        wrong += all.empty() ? 0 : 1;
        continue;
      }
      wrong += static_cast<int>(all.size()) == grains ? 0 : 1;
      for (std::size_t i = 0; i < all.size(); ++i) {
        wrong += same(all[i], grain(static_cast<int>(i) + 1)) ? 0 : 1;
      }
    }
  }
  int sum = 0;
  MPI_Allreduce(&wrong, &sum, 1, MPI_INT, MPI_SUM, MPI_COMM_WORLD);
  if (rank == 0) std::printf("%d ranks: %d wrong\n", ranks, sum);
  MPI_Finalize();
  return sum == 0 ? 0 : 1;
}
