// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/flow/flow_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "analysis/flow/dem_time_step.h"
#include "models/invalid_input.h"

namespace powderlink::analysis {

namespace fs = std::filesystem;

namespace {

constexpr double kStillFilling = 0.05;  // change of the number of particles over the run's end

void read_particles(const fs::path& folder, const std::vector<fs::path>& dumps, FlowReport& report,
                    const FlowProgress& progress) {
  std::optional<double> dt_s;
  std::size_t done = 0;
  for (const fs::path& dump : dumps) {
    read_dump(dump, [&](const DumpState& state) {
      if (!state.time_s && !dt_s) dt_s = dem_time_step_s(folder, report.options.time_step_s);
      report.particles.add(state.time_s ? *state.time_s : static_cast<double>(state.step) * *dt_s,
                           state);
    });
    if (progress) progress(++done, dumps.size());
  }
}

void judge_particles(FlowReport& report) {
  const FlowStatistics& p = report.particles;
  const FlowWindow& window = p.window();
  report.times_s = p.established_times_s();
  if (report.times_s.empty()) {
    throw InvalidInput("option --from", fmt::format("{:g} s", window.from_s),
                       fmt::format("{:g} to {:g} s, the times of the dumps",
                                   p.states().front().time_s, p.states().back().time_s),
                       "give an earlier time from which the flow counts as established");
  }
  if (report.times_s.size() > 2) {
    const auto& last = p.states().back();
    const auto& half = p.states()[p.states().size() - 1 - report.times_s.size() / 2];
    const double change =
        std::abs(static_cast<double>(last.particles) - static_cast<double>(half.particles));
    if (change > kStillFilling * static_cast<double>(last.particles)) {
      report.notes.push_back(fmt::format(
          "the number of particles still changes, {} at {:g} s and {} at {:g} s: the flow is not "
          "established; run longer, or give a later --from",
          half.particles, half.time_s, last.particles, last.time_s));
    }
  }
  if (!p.velocity_mean_m_s()) {
    report.notes.push_back(fmt::format(
        "no particle velocity: no particle beyond z = {:g} m; give --from-z", window.from_z_m));
  }
  report.slice_m = p.flow_slice_m(report.options.slice_m);
  if (!report.slice_m) {
    report.notes.push_back(
        fmt::format("no solids flow: no particle beyond z = {:g} m; give --slice or --from-z",
                    window.from_z_m));
    return;
  }
  report.flow_kg_s = p.solids_flow_kg_s(*report.slice_m);
  report.average_kg_s = moving_average(report.times_s, report.flow_kg_s, report.options.average_s);
  double sum = 0.0;
  for (const double flow : report.flow_kg_s) sum += flow;
  report.mean_flow_kg_s = sum / static_cast<double>(report.flow_kg_s.size());
  report.irregularity = irregularity(report.average_kg_s);
  if (!report.irregularity) {
    report.notes.push_back(
        fmt::format("no RMS of the solids flow: {} dumps in {:g} s leave fewer than two averages "
                    "over {:g} s, or "
                    "nothing flows; dump more often, run longer, or give a shorter --average",
                    report.times_s.size(), report.times_s.back() - report.times_s.front(),
                    report.options.average_s));
  } else if (const double apart = (report.times_s.back() - report.times_s.front()) /
                                  static_cast<double>(report.times_s.size() - 1);
             report.options.average_s < apart) {
    report.notes.push_back(fmt::format(
        "the dumps are {:g} s apart, further than the {:g} s of the moving average, which then "
        "hardly averages: dump more often for a comparison with other runs",
        apart, report.options.average_s));
  }
}

void read_gas(const fs::path& folder, FlowReport& report) {
  const std::vector<std::string> sets = pressure_probe_sets(folder);
  if (sets.empty() && report.options.probes.empty()) {
    report.notes.push_back(
        "no pressure: postProcessing/ holds no probes of p; add a function object `probes` with "
        "fields (p) to system/controlDict");
    return;
  }
  const auto density = gas_density_kg_m3(folder, report.options.density_kg_m3);
  if (!density) {
    report.notes.push_back(
        "no pressure in Pa: constant/transportProperties has no rho; give --density kg/m^3");
    return;
  }
  const FlowWindow& window = report.options.window;
  const auto in_window = [&](const PressureProfile& profile) {
    return std::count_if(profile.probes.begin(), profile.probes.end(), [&](const ProbeMean& p) {
      return p.z_m >= window.from_z_m && p.z_m <= window.to_z_m;
    });
  };
  const std::string& wanted = report.options.probes;
  for (const std::string& set : wanted.empty() ? sets : std::vector<std::string>{wanted}) {
    PressureProfile profile = read_pressure(folder, set, *density, window.from_s);
    if (!report.pressure || in_window(profile) > in_window(*report.pressure)) {
      report.pressure = std::move(profile);
    }
  }
  if (wanted.empty() && sets.size() > 1) {
    report.notes.push_back(fmt::format(
        "{} sets of probes recorded p; used is '{}', which has the most in the window; --probes "
        "chooses another",
        sets.size(), report.pressure->name));
  }
  report.slope = fit_slope(*report.pressure, window.from_z_m, window.to_z_m);
  if (!report.slope) {
    report.notes.push_back(
        fmt::format("no pressure slope: the probes '{}' have no two places in z = {:g} to {:g} m "
                    "with values after {:g} s; give --from-z, --to-z or --from",
                    report.pressure->name, window.from_z_m, window.to_z_m, window.from_s));
  }
}

std::string cell(const std::optional<double>& value) {
  return value ? fmt::format("{:.9g}", *value) : "";
}

std::string pressure_table(const FlowReport& report) {
  std::string text = fmt::format("# mean over {} times; pressure = kinematic pressure x density\n",
                                 report.pressure->rows);
  if (report.slope) {
    text += fmt::format("# slope {:.9g} Pa/m, r squared {:.6f}, {} probes\n",
                        report.slope->slope_Pa_m, report.slope->r_squared, report.slope->probes);
  }
  text += "z_m,pressure_Pa,fit_Pa\n";
  const FlowWindow& window = report.options.window;
  for (const ProbeMean& probe : report.pressure->probes) {
    std::optional<double> fit;
    if (report.slope && probe.z_m >= window.from_z_m && probe.z_m <= window.to_z_m) {
      fit = report.slope->intercept_Pa - report.slope->slope_Pa_m * probe.z_m;
    }
    text += fmt::format("{:.9g},{:.9g},{}\n", probe.z_m, probe.pressure_Pa, cell(fit));
  }
  return text;
}

std::string flow_table(const FlowReport& report) {
  std::string text;
  if (report.slice_m) {
    text = fmt::format(
        "# sum(m v)/dz in the slice z = {:.9g} to {:.9g} m; moving average over {:g} s\n",
        report.slice_m->from, report.slice_m->to, report.options.average_s);
  }
  text += "time_s,particle_count,solids_flow_kg_s,moving_average_kg_s\n";
  std::size_t i = 0;
  for (const auto& state : report.particles.states()) {
    const bool counts = state.time_s >= report.options.window.from_s && i < report.flow_kg_s.size();
    text += fmt::format("{:.9g},{},{},{}\n", state.time_s, state.particles,
                        cell(counts ? std::optional(report.flow_kg_s[i]) : std::nullopt),
                        cell(counts ? report.average_kg_s[i] : std::nullopt));
    if (counts) ++i;
  }
  return text;
}

std::string height_table(const FlowStatistics& p) {
  std::string text = "z_m,count,y_05_m,y_25_m,y_50_m,y_75_m,y_95_m\n";
  for (const auto& [k, slice] : p.profile()) {
    text += fmt::format("{:.9g},{}", p.centre_m(k), slice.y.count());
    for (const double share : {0.05, 0.25, 0.5, 0.75, 0.95}) {
      text += fmt::format(",{:.6g}", slice.y.quantile(share));
    }
    text += "\n";
  }
  return text;
}

std::string velocity_table(const FlowStatistics& p) {
  namespace acc = boost::accumulators;
  std::string text = "z_m,count,velocity_mean_m_s,velocity_std_m_s\n";
  for (const auto& [k, slice] : p.profile()) {
    text += fmt::format("{:.9g},{},{:.6g},{:.6g}\n", p.centre_m(k), acc::count(slice.velocity_m_s),
                        acc::mean(slice.velocity_m_s),
                        std::sqrt(std::max(0.0, acc::variance(slice.velocity_m_s))));
  }
  return text;
}

std::string width_table(const FlowStatistics& p) {
  std::string text =
      "# central intervals that hold 50, 90 and 99 % of the particles of a slice\n"
      "z_m,count,x_50_m,x_90_m,x_99_m,y_50_m,y_90_m,y_99_m\n";
  for (const auto& [k, slice] : p.profile()) {
    text += fmt::format("{:.9g},{}", p.centre_m(k), slice.x.count());
    for (const auto* axis : {&slice.x, &slice.y}) {
      for (const double share : {0.5, 0.9, 0.99}) {
        text += fmt::format(",{:.6g}", axis->central_width(share));
      }
    }
    text += "\n";
  }
  return text;
}

/// All slices at all times, empty ones too: a figure needs the whole rectangle.
std::string concentration_table(const FlowStatistics& p) {
  std::string text = "time_s,z_m,number_per_m,mass_kg_m\n";
  long first = 0, last = -1;
  for (const auto& state : p.states()) {
    if (state.slices.empty()) continue;
    const bool none = last < first;
    first = none ? state.slices.begin()->first : std::min(first, state.slices.begin()->first);
    last = none ? state.slices.rbegin()->first : std::max(last, state.slices.rbegin()->first);
  }
  const double dz = p.window().slice_m;
  for (const auto& state : p.states()) {
    for (long k = first; k <= last; ++k) {
      const auto at = state.slices.find(k);
      const SliceState slice = at == state.slices.end() ? SliceState{} : at->second;
      text += fmt::format("{:.9g},{:.9g},{:.6g},{:.6g}\n", state.time_s, p.centre_m(k),
                          static_cast<double>(slice.count) / dz, slice.mass_kg / dz);
    }
  }
  return text;
}

}  // namespace

fs::path find_coupled_case(const fs::path& folder) {
  if (!fs::is_directory(folder)) {
    throw InvalidInput("opening the case", folder.string(), "the folder of a coupled case",
                       "correct the path");
  }
  const auto has_run = [](const fs::path& place) {
    return fs::exists(place / "post") || fs::exists(place / "postProcessing") ||
           fs::exists(place / "log.powderFoam") || fs::exists(place / "log.mpirun");
  };
  const fs::path inside = folder / "results" / "case";
  return !has_run(folder) && has_run(inside) ? inside : folder;
}

FlowReport analyse_flow(const fs::path& folder, const FlowOptions& options,
                        const FlowProgress& progress) {
  if (!(options.average_s > 0.0 && std::isfinite(options.average_s))) {
    throw InvalidInput("option --average", number_text(options.average_s) + " s", "above 0 s",
                       "give the window of the moving average, such as 2e-3");
  }
  FlowReport report(options);
  std::vector<fs::path> dumps;
  std::string no_dumps;
  try {
    dumps = list_dumps(folder);
  } catch (const InvalidInput& e) {
    no_dumps = e.what();
  }
  read_gas(folder, report);
  if (!dumps.empty()) {
    read_particles(folder, dumps, report, progress);
    judge_particles(report);
  } else if (!report.pressure) {
    throw InvalidInput("analysing " + folder.string(),
                       "neither particles in post/particles_*.dump nor pressure in Pa",
                       "the folder of a coupled run",
                       "give the folder in which the run happened; notes: " +
                           (report.notes.empty() ? "none" : report.notes.back()));
  } else {
    report.notes.push_back("no particles: " + no_dumps);
  }
  report.cost = read_solver_cost(folder, options.window.from_s);
  if (!report.cost.wall_s_per_simulated_ms) {
    report.notes.push_back(
        "no wall clock: neither log.powderFoam nor log.mpirun has two times with ClockTime after "
        "--from");
  } else if (report.cost.by_processor_time) {
    report.notes.push_back("the run is short: cost is processor time, not wall clock");
  }
  if (!report.cost.coupling_share_percent) {
    report.notes.push_back("no coupling share: the solver's log has no line `coupling share: X %`");
  }
  return report;
}

std::string flow_json(const FlowReport& report) {
  const auto or_null = [](const std::optional<double>& value) {
    return value && std::isfinite(*value) ? nlohmann::ordered_json(*value)
                                          : nlohmann::ordered_json(nullptr);
  };
  nlohmann::ordered_json j;
  j["pressure_slope_Pa_m"] =
      or_null(report.slope ? std::optional(report.slope->slope_Pa_m) : std::nullopt);
  j["solids_flow_kg_s"] = or_null(report.mean_flow_kg_s);
  j["solids_flow_rms_percent"] =
      or_null(report.irregularity ? std::optional(report.irregularity->rms_percent) : std::nullopt);
  j["window_s"] = report.options.average_s;
  j["particle_velocity_mean_m_s"] = or_null(report.particles.velocity_mean_m_s());
  j["particle_velocity_std_m_s"] = or_null(report.particles.velocity_deviation_m_s());
  j["particle_count"] = or_null(report.particles.mean_particles());
  j["coupling_share_percent"] = or_null(report.cost.coupling_share_percent);
  j["wall_s_per_simulated_ms"] = or_null(report.cost.wall_s_per_simulated_ms);
  return j.dump(1) + "\n";
}

std::vector<std::pair<std::string, std::string>> flow_tables(const FlowReport& report) {
  std::vector<std::pair<std::string, std::string>> tables;
  if (report.pressure) tables.emplace_back("pressure.csv", pressure_table(report));
  if (!report.particles.states().empty()) {
    tables.emplace_back("solids_flow.csv", flow_table(report));
    tables.emplace_back("height.csv", height_table(report.particles));
    tables.emplace_back("velocity.csv", velocity_table(report.particles));
    tables.emplace_back("width.csv", width_table(report.particles));
    tables.emplace_back("concentration.csv", concentration_table(report.particles));
  }
  return tables;
}

}  // namespace powderlink::analysis
