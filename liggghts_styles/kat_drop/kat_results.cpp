// SPDX-License-Identifier: GPL-3.0-or-later
#include "liggghts_styles/kat_drop/kat_results.h"

#include <algorithm>
#include <cstdio>
#include <fstream>

#include <nlohmann/json.hpp>

#include "base/invalid_input.h"

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

void write(const KatResults& r, const std::string& file) {
  using nlohmann::json;
  const auto or_null = [](double value) { return value > 0.0 ? json(value) : json(nullptr); };
  json grains = json::array();
  long attached = 0;
  for (const KatGrainResult& g : r.grains) {
    attached += g.attached > 0.0 ? 1 : 0;
    grains.push_back({{"id", static_cast<long>(g.id)},
                      {"diameter_m", g.diameter_m},
                      {"attached", g.attached > 0.0},
                      {"speed_m_s", g.speed_m_s},
                      {"balance", g.energy_residual},
                      {"momentum_balance", g.momentum_residual}});
  }
  const json document = {{"impact_velocity_m_s", r.impact_velocity_m_s},
                         {"critical_diameter_m", or_null(r.critical_diameter_m)},
                         {"largest_attached_m", or_null(r.largest_attached_m)},
                         {"smallest_detached_m", or_null(r.smallest_detached_m)},
                         {"attached", attached},
                         {"detached", static_cast<long>(r.grains.size()) - attached},
                         {"out_of_order", r.out_of_order},
                         {"steps", r.steps},
                         {"impact_step", r.impact_step},
                         {"time_step_s", r.time_step_s},
                         {"particles", grains}};
  const std::string beside = file + ".part";
  std::ofstream out(beside);
  out << document.dump(1) << '\n';
  out.close();
  if (!out || std::rename(beside.c_str(), file.c_str()) != 0) {
    std::remove(beside.c_str());
    throw InvalidInput("results file", file, "a file in a writable folder with room on the disk",
                       "check the folder and free space");
  }
}

}  // namespace powderlink::host
