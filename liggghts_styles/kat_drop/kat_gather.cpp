// SPDX-License-Identifier: GPL-3.0-or-later
#include "liggghts_styles/kat_drop/kat_gather.h"

#include <algorithm>

namespace powderlink::host {

std::vector<KatGrainResult> gather(const std::vector<KatGrainResult>& mine, MPI_Comm world) {
  constexpr int width = sizeof(KatGrainResult) / sizeof(double);
  int rank = 0, ranks = 1;
  MPI_Comm_rank(world, &rank);
  MPI_Comm_size(world, &ranks);
  const int count = static_cast<int>(mine.size()) * width;
  std::vector<int> counts(ranks), offsets(ranks);
  MPI_Gather(&count, 1, MPI_INT, counts.data(), 1, MPI_INT, 0, world);
  for (int r = 1; r < ranks; ++r) offsets[r] = offsets[r - 1] + counts[r - 1];
  std::vector<KatGrainResult> all;
  if (rank == 0) all.resize((offsets.back() + counts.back()) / width);
  MPI_Gatherv(mine.data(), count, MPI_DOUBLE, all.data(), counts.data(), offsets.data(), MPI_DOUBLE,
              0, world);
  std::sort(all.begin(), all.end(),
            [](const KatGrainResult& a, const KatGrainResult& b) { return a.id < b.id; });
  return all;
}

}  // namespace powderlink::host
