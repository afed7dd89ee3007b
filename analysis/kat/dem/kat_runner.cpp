// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/kat/dem/kat_runner.h"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <stdexcept>
#include <thread>

#include "base/process/progress.h"

namespace powderlink::analysis {

namespace fs = std::filesystem;

namespace {

constexpr double kBelowExpected = 0.8;
constexpr double kAboveExpected = 1.25;
constexpr int kExpectedRounds = 2;

SearchRange first_range(const Study& study, const KatPoint& point) {
  if (const auto& given = study.kat.diameter_range_um)
    return {given->first * 1e-6, given->second * 1e-6, true};
  if (!point.reduced.found()) {
    throw InvalidInput(
        "critical diameter of the reduced model", point.reduced.text_um() + " um", "0.1 to 1000 um",
        point.reduced.state == CriticalDiameter::State::nothing_detaches
            ? "raise the velocity, lower the adhesive energy, or give diameter_range_um"
            : "lower the velocity, raise the adhesive energy, or give diameter_range_um");
  }
  return {kBelowExpected * point.reduced.diameter_m, kAboveExpected * point.reduced.diameter_m,
          false};
}

void run_row(const Study& study, const KatRunOptions& options, std::size_t index, KatPoint& point,
             Progress& progress) {
  const fs::path folder = options.out / fmt::format("row_{:02d}", index + 1);
  DropScript drop;
  drop.title = fmt::format("{}, row {}", study.name, index + 1);
  drop.particle = study.particle;
  drop.substrate = study.substrate;
  drop.work_of_adhesion_J_m2 = point.adhesive_energy_J_m2;
  drop.impact_velocity_m_s = point.row.impact_velocity_m_s;
  drop.effects = row_effects(study.effects, point.row);
  drop.options = study.kat;
  const auto run = [&](double smallest, double largest, int round) {
    drop.smallest_diameter_m = smallest;
    drop.largest_diameter_m = largest;
    if (round > kExpectedRounds) progress.expect_more(1);
    DropResult result = run_drop(options.runner, drop, folder / fmt::format("round_{}", round));
    // The first run has the widest range of sizes: that is the one to look at.
    if (round > 1 && !options.keep_all_pictures) {
      fs::remove_all(folder / fmt::format("round_{}", round) / "post");
    }
    progress.step_done(
        fmt::format("{:g} m/s, {:.4g} to {:.4g} um{}", drop.impact_velocity_m_s, smallest * 1e6,
                    largest * 1e6, result.reused ? " (was finished)" : ""),
        result.reused);
    return result;
  };
  point.dem = search_critical_diameter(run, first_range(study, point), options.resolution);
}

}  // namespace

std::vector<KatPoint> run_study(const Study& study, const std::vector<double>& energies,
                                const KatRunOptions& options) {
  std::vector<KatPoint> points;
  for (std::size_t i = 0; i < study.rows.size(); ++i) {
    const KatRow& row = study.rows[i];
    const ReducedModel model(row_setup(study, row, energies[i]));
    points.push_back({row,
                      energies[i],
                      theory_diameter(model, row.impact_velocity_m_s),
                      critical_diameter(model, row.impact_velocity_m_s),
                      {}});
  }

  Progress progress("kat run", kExpectedRounds * static_cast<int>(points.size()));
  std::atomic<std::size_t> next{0};
  std::mutex mutex;
  std::string failure;
  const auto work = [&] {
    for (std::size_t i = next++; i < points.size(); i = next++) {
      try {
        run_row(study, options, i, points[i], progress);
      } catch (const std::exception& e) {
        next = points.size();  // the others end what they have begun
        const std::lock_guard<std::mutex> lock(mutex);
        if (failure.empty()) {
          failure = fmt::format("row {} ({:g} m/s): {}", i + 1, points[i].row.impact_velocity_m_s,
                                e.what());
        }
      }
    }
  };
  std::vector<std::thread> workers;
  const int jobs = std::clamp(options.jobs, 1, static_cast<int>(points.size()));
  workers.reserve(static_cast<std::size_t>(jobs));
  for (int j = 0; j < jobs; ++j) workers.emplace_back(work);
  for (std::thread& t : workers) t.join();
  if (!failure.empty()) throw std::runtime_error(failure);
  return points;
}

}  // namespace powderlink::analysis
