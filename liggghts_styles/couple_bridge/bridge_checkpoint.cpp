// SPDX-License-Identifier: GPL-3.0-or-later
#include "liggghts_styles/couple_bridge/bridge_checkpoint.h"

#include <algorithm>
#include <cstddef>
#include <cstring>

namespace powderlink::host {

namespace {

constexpr double kFormat = 3.0;
constexpr double kFormatBefore = 2.0;  // without what was counted
constexpr std::size_t kHead = 6;
constexpr std::size_t kNumbers = LeavingParticles::kDoubles;

}  // namespace

void BridgeCheckpoint::write(std::FILE* file, MPI_Comm world) const {
  int rank = 0, ranks = 1;
  MPI_Comm_rank(world, &rank);
  MPI_Comm_size(world, &ranks);
  std::vector<double> mine = {static_cast<double>(insertion.size())};
  mine.insert(mine.end(), insertion.begin(), insertion.end());
  const int count = static_cast<int>(mine.size());
  std::vector<int> counts(static_cast<std::size_t>(ranks)), starts(counts.size());
  MPI_Gather(&count, 1, MPI_INT, counts.data(), 1, MPI_INT, 0, world);
  const std::size_t head = kHead + kNumbers * gone.size() + counted.size();
  int size = static_cast<int>(head);
  for (std::size_t r = 0; r < counts.size(); ++r) {
    starts[r] = size;
    size += counts[r];
  }
  std::vector<double> all(static_cast<std::size_t>(size));
  MPI_Gatherv(mine.data(), count, MPI_DOUBLE, all.data(), counts.data(), starts.data(), MPI_DOUBLE,
              0, world);
  if (rank != 0) return;
  all[0] = kFormat;
  all[1] = static_cast<double>(step);
  all[2] = ahead_s;
  all[3] = ranks;
  all[4] = static_cast<double>(gone.size());
  all[5] = static_cast<double>(counted.size());
  if (!gone.empty()) std::memcpy(&all[kHead], gone.data(), gone.size() * sizeof gone[0]);
  std::copy(counted.begin(), counted.end(), all.begin() + kHead + kNumbers * gone.size());
  const int bytes = static_cast<int>(all.size() * sizeof(double));
  std::fwrite(&bytes, sizeof bytes, 1, file);
  std::fwrite(all.data(), sizeof(double), all.size(), file);
}

BridgeCheckpoint BridgeCheckpoint::read(const char* state, MPI_Comm world) {
  int rank = 0, ranks = 1;
  MPI_Comm_rank(world, &rank);
  MPI_Comm_size(world, &ranks);
  const auto number = [state](std::size_t i) {
    double value = 0.0;
    std::memcpy(&value, state + i * sizeof(double), sizeof value);
    return value;
  };
  BridgeCheckpoint checkpoint;
  const bool before = number(0) == kFormatBefore;
  if (number(0) != kFormat && !before) return checkpoint;
  const std::size_t head = before ? kHead - 1 : kHead;
  checkpoint.step = static_cast<std::int64_t>(number(1));
  checkpoint.ahead_s = number(2);
  checkpoint.gone.resize(static_cast<std::size_t>(number(4)));
  for (std::size_t i = 0; i < checkpoint.gone.size(); ++i) {
    std::memcpy(&checkpoint.gone[i], state + (head + kNumbers * i) * sizeof(double),
                sizeof checkpoint.gone[i]);
  }
  std::size_t at = head + kNumbers * checkpoint.gone.size();
  for (double left = before ? 0.0 : number(5); left > 0.0; --left) {
    checkpoint.counted.push_back(number(at++));
  }
  if (static_cast<int>(number(3)) != ranks) return checkpoint;
  for (int r = 0; r < rank; ++r) at += 1 + static_cast<std::size_t>(number(at));
  const auto count = static_cast<std::size_t>(number(at));
  for (std::size_t i = 1; i <= count; ++i) checkpoint.insertion.push_back(number(at + i));
  return checkpoint;
}

}  // namespace powderlink::host
