// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/flow/flow_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <tuple>

#include "analysis/flow/foam/foam_files.h"
#include "analysis/flow/observables/flow_observables.h"
#include "analysis/flow/run/flow_channel.h"
#include "analysis/flow/run/particle_clock.h"
#include "base/invalid_input.h"

namespace powderlink::analysis {

namespace fs = std::filesystem;

namespace {

constexpr double kStillFilling = 0.05;  // change of the number of particles over the run's end
constexpr double kThickest_m = 1e-3;    // of a slice that nobody asked for
constexpr double kFewestSlices = 20.0;  // of a channel, by such slices

FlowWindow window_of(const FlowChannel& channel, const FlowOptions& options) {
  FlowWindow window;
  window.from_s = options.from_s;
  window.axis = channel.axis;
  if (!options.from_m && !options.to_m) {
    std::tie(window.from_m, window.to_m) = channel.developed_m();
  }
  window.from_m = options.from_m.value_or(window.from_m);
  window.to_m = options.to_m.value_or(window.to_m);
  window.slice_m = kThickest_m;
  if (const auto stretch = channel.stretch_m(); stretch && stretch->second > stretch->first) {
    window.slice_m = std::min(kThickest_m, (stretch->second - stretch->first) / kFewestSlices);
  }
  window.slice_m = options.slice_m.value_or(window.slice_m);
  return window;
}

/// A flow is momentum over length: beyond the channel there is only length.
void require_within(const FlowChannel& channel, const FlowOptions& options) {
  const auto reach = channel.reach_m();
  if (!reach) return;
  const double length_m = reach->second - reach->first;
  const std::string channel_text = fmt::format("{} = {:g} to {:g} m, mesh and LIGGGHTS's box",
                                               channel.axis.letter(), reach->first, reach->second);
  constexpr const char* kCure = "correct the option; lengths are in metres";
  if (options.slice_m && *options.slice_m > length_m) {
    throw InvalidInput("option --slice-thickness", fmt::format("{:g} m", *options.slice_m),
                       "at most the length of the channel: " + channel_text, kCure);
  }
  const double hair_m = 1e-6 * length_m;  // digits of a dump's box
  if (const auto& slice = options.flow_slice_m;
      slice && (slice->from < reach->first - hair_m || slice->to > reach->second + hair_m)) {
    throw InvalidInput("option --slice", fmt::format("{:g} {:g}", slice->from, slice->to),
                       "two places in the channel: " + channel_text, kCure);
  }
}

/// `z >= 0.2 m`, in words.
std::string text_of(const FlowWindow& window) {
  const char letter = window.axis.letter();
  const bool from = std::isfinite(window.from_m), to = std::isfinite(window.to_m);
  if (from && to) return fmt::format("{} = {:g} to {:g} m", letter, window.from_m, window.to_m);
  if (from) return fmt::format("{} >= {:g} m", letter, window.from_m);
  if (to) return fmt::format("{} <= {:g} m", letter, window.to_m);
  return fmt::format("all {}", letter);
}

void read_particles(const fs::path& folder, const std::vector<fs::path>& dumps,
                    ParticleClock& clock, FlowObservables& observables, FlowReport& report,
                    const FlowProgress& progress) {
  if (!clock.known() && foam_file_exists(folder / "constant" / "couplingProperties")) {
    report.notes.emplace_back(
        "powderFoam has not written fields yet: times are those of LIGGGHTS, "
        "which is ahead of the gas if it ran before the first exchange; "
        "wait for the first time folder in that case");
  }
  std::size_t done = 0;
  for (const auto& observable : observables) observable->begin(folder);
  for (const fs::path& dump : dumps) {
    read_dump(dump, [&](const DumpState& state) {
      const double time_s = clock.gas_time_s(state);
      report.particles.add(time_s, state);
      if (time_s < report.window().from_s) return;
      for (const auto& observable : observables) observable->add(time_s, state);
    });
    if (progress) progress(++done, dumps.size());
  }
}

void judge_particles(FlowReport& report) {
  FlowStatistics& p = report.particles;
  const FlowWindow& window = p.window();
  const bool chosen = report.options.from_m || report.options.to_m;
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
      report.notes.push_back(
          fmt::format("the number of particles still changes, {} at {:g} s and {} at {:g} s: "
                      "the flow is not established; run longer, or give a later --from",
                      half.particles, half.time_s, last.particles, last.time_s));
    }
  }
  const bool part = std::isfinite(window.from_m) || std::isfinite(window.to_m);
  if (part && !chosen && !p.velocity_mean_m_s()) {
    const std::string downstream = text_of(window);
    p.widen();
    if (p.velocity_mean_m_s()) {
      report.notes.push_back(
          fmt::format("no particle came to {}, the last third of the channel: all of it counts; "
                      "give --from-z and --to-z for a part",
                      downstream));
    }
  }
  if (!p.velocity_mean_m_s()) {
    report.notes.push_back(p.states().back().particles == 0 && p.profile().empty()
                               ? "no particle velocity: no particle in any dump from --from on"
                               : fmt::format("no particle velocity: no particle at {}; "
                                             "give --from-z or --to-z",
                                             text_of(window)));
  }
  report.slice_m = p.flow_slice_m(report.options.flow_slice_m);
  if (!report.slice_m) {
    report.notes.push_back(fmt::format(
        "no solids flow: no particle at {}; give --slice, --from-z or --to-z", text_of(window)));
    return;
  }
  report.flow_kg_s = p.solids_flow_kg_s(*report.slice_m);
  report.average_kg_s =
      moving_average(report.times_s, report.flow_kg_s, report.options.measures.average_s);
  double sum = 0.0;
  for (const double flow : report.flow_kg_s) sum += flow;
  report.mean_flow_kg_s = sum / static_cast<double>(report.flow_kg_s.size());
  report.irregularity = irregularity(report.average_kg_s);
  if (!report.irregularity) {
    report.notes.push_back(
        fmt::format("no RMS of the solids flow: "
                    "{} dumps in {:g} s leave fewer than two averages over {:g} s, "
                    "or nothing flows; dump more often, run longer, or give a shorter --average",
                    report.times_s.size(), report.times_s.back() - report.times_s.front(),
                    report.options.measures.average_s));
  } else if (const double apart = (report.times_s.back() - report.times_s.front()) /
                                  static_cast<double>(report.times_s.size() - 1);
             report.options.measures.average_s < apart) {
    report.notes.push_back(
        fmt::format("the dumps are {:g} s apart, further than the {:g} s of the moving average, "
                    "which then hardly averages: dump more often for a comparison with other runs",
                    apart, report.options.measures.average_s));
  }
}

void read_gas(const fs::path& folder, FlowReport& report) {
  if (report.options.density_kg_m3) {
    report.gas_density_kg_m3 = gas_density_kg_m3(folder, report.options.density_kg_m3);
  }
  const std::vector<std::string> sets = pressure_probe_sets(folder);
  if (sets.empty() && report.options.probes.empty()) {
    report.notes.push_back(
        "no pressure: postProcessing/ holds no probes of p; "
        "add a function object `probes` with fields (p) to system/controlDict");
    return;
  }
  const auto density = gas_density_kg_m3(folder, report.options.density_kg_m3);
  report.gas_density_kg_m3 = density;
  if (!density) {
    report.notes.push_back(
        "no pressure in Pa: constant/transportProperties has no rho; give --density kg/m^3");
    return;
  }
  const FlowWindow& window = report.window();
  const auto in_window = [&](const PressureProfile& profile) {
    return std::count_if(profile.probes.begin(), profile.probes.end(),
                         [&](const ProbeMean& p) { return window.holds(p.place_m); });
  };
  const std::string& wanted = report.options.probes;
  for (const std::string& set : wanted.empty() ? sets : std::vector<std::string>{wanted}) {
    PressureProfile profile = read_pressure(folder, set, *density, window.from_s, window.axis);
    if (!report.pressure || in_window(profile) > in_window(*report.pressure)) {
      report.pressure = std::move(profile);
    }
  }
  if (wanted.empty() && sets.size() > 1) {
    report.notes.push_back(
        fmt::format("{} sets of probes recorded p; "
                    "used is '{}', which has the most in the window; --probes chooses another",
                    sets.size(), report.pressure->name));
  }
  report.slope = fit_slope(*report.pressure, window.from_m, window.to_m, window.axis);
  if (!report.slope && !report.options.from_m && !report.options.to_m) {
    constexpr double kInfinity = std::numeric_limits<double>::infinity();
    report.slope = fit_slope(*report.pressure, -kInfinity, kInfinity, window.axis);
    if (report.slope) {
      report.notes.push_back(
          fmt::format("fewer than two probes at {}, the last third of the channel: "
                      "the pressure slope is that of all probes",
                      text_of(window)));
    }
  }
  if (!report.slope) {
    report.notes.push_back(
        fmt::format("no pressure slope: "
                    "the probes '{}' have no two places at {} with values after {:g} s; "
                    "give --from-z, --to-z or --from",
                    report.pressure->name, text_of(window), window.from_s));
  }
}

FlowChannelShape shape_of(const FlowChannel& channel) {
  FlowChannelShape shape;
  if (const auto reach = channel.reach_m()) shape.reach_m = Interval{reach->first, reach->second};
  if (!channel.mesh) return shape;
  const FlowAxis& axis = channel.axis;
  shape.reach_m = Interval{channel.mesh->low_m.at(axis.index), channel.mesh->high_m.at(axis.index)};
  shape.radius_m =
      0.5 * std::max(channel.mesh->length_m(axis.across()), channel.mesh->length_m(axis.up()));
  for (std::size_t i = 0; i < 3; ++i) {
    shape.centre_m[i] = 0.5 * (channel.mesh->low_m[i] + channel.mesh->high_m[i]);
  }
  return shape;
}

/// Needs the gas, so after read_gas().
void observe(const fs::path& folder, const FlowChannel& channel, ParticleClock& clock,
             FlowObservables& observables, FlowReport& report) {
  FlowScene scene;
  scene.folder = folder;
  scene.particles = &report.particles;
  scene.measures = report.options.measures;
  scene.reach_m = shape_of(channel).reach_m;
  if (channel.mesh) scene.mesh_m = scene.reach_m;
  scene.flow_slice_m = report.slice_m;
  if (report.irregularity) scene.irregularity_percent = report.irregularity->rms_percent;
  scene.gas_density_kg_m3 = report.gas_density_kg_m3;
  if (report.pressure) scene.pressure = &*report.pressure;
  scene.clock = &clock;
  for (const auto& observable : observables) {
    report.findings.push_back(observable->find(scene));
    for (const std::string& note : report.findings.back().notes) report.notes.push_back(note);
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
  const FlowWindow& window = report.window();
  text += fmt::format("{}_m,pressure_Pa,fit_Pa\n", window.axis.letter());
  for (const ProbeMean& probe : report.pressure->probes) {
    std::optional<double> fit;
    if (report.slope && probe.place_m >= report.slope->from_m &&
        probe.place_m <= report.slope->to_m) {
      fit = report.slope->intercept_Pa - window.axis.way * report.slope->slope_Pa_m * probe.place_m;
    }
    text += fmt::format("{:.9g},{:.9g},{}\n", probe.place_m, probe.pressure_Pa, cell(fit));
  }
  return text;
}

std::string flow_table(const FlowReport& report) {
  std::string text;
  if (report.slice_m) {
    text = fmt::format(
        "# sum(m v)/d{0} in the slice {0} = {1:.9g} to {2:.9g} m; moving average over {3:g} s\n",
        report.window().axis.letter(), report.slice_m->from, report.slice_m->to,
        report.options.measures.average_s);
  }
  text += "time_s,particle_count,solids_flow_kg_s,moving_average_kg_s\n";
  std::size_t i = 0;
  for (const auto& state : report.particles.states()) {
    const bool counts = state.time_s >= report.window().from_s && i < report.flow_kg_s.size();
    text += fmt::format("{:.9g},{},{},{}\n", state.time_s, state.particles,
                        cell(counts ? std::optional(report.flow_kg_s[i]) : std::nullopt),
                        cell(counts ? report.average_kg_s[i] : std::nullopt));
    if (counts) ++i;
  }
  return text;
}

std::string height_table(const FlowStatistics& p) {
  const FlowAxis& axis = p.window().axis;
  std::string text = fmt::format("{0}_m,count,{1}_05_m,{1}_25_m,{1}_50_m,{1}_75_m,{1}_95_m\n",
                                 axis.letter(), "xyz"[axis.up()]);
  for (const auto& [k, slice] : p.profile()) {
    text += fmt::format("{:.9g},{}", p.centre_m(k), slice.up.count());
    for (const double share : {0.05, 0.25, 0.5, 0.75, 0.95}) {
      text += fmt::format(",{:.6g}", slice.up.quantile(share));
    }
    text += "\n";
  }
  return text;
}

std::string velocity_table(const FlowStatistics& p) {
  namespace acc = boost::accumulators;
  std::string text =
      fmt::format("{}_m,count,velocity_mean_m_s,velocity_std_m_s\n", p.window().axis.letter());
  for (const auto& [k, slice] : p.profile()) {
    text += fmt::format("{:.9g},{},{:.6g},{:.6g}\n", p.centre_m(k), acc::count(slice.velocity_m_s),
                        acc::mean(slice.velocity_m_s),
                        std::sqrt(std::max(0.0, acc::variance(slice.velocity_m_s))));
  }
  return text;
}

std::string width_table(const FlowStatistics& p) {
  const FlowAxis& axis = p.window().axis;
  std::string text = fmt::format(
      "# central intervals that hold 50, 90 and 99 % of the particles of a slice\n"
      "{0}_m,count,{1}_50_m,{1}_90_m,{1}_99_m,{2}_50_m,{2}_90_m,{2}_99_m\n",
      axis.letter(), "xyz"[axis.across()], "xyz"[axis.up()]);
  for (const auto& [k, slice] : p.profile()) {
    text += fmt::format("{:.9g},{}", p.centre_m(k), slice.across.count());
    for (const auto* side : {&slice.across, &slice.up}) {
      for (const double share : {0.5, 0.9, 0.99}) {
        text += fmt::format(",{:.6g}", side->central_width(share));
      }
    }
    text += "\n";
  }
  return text;
}

/// All slices at all times, empty ones too: a figure needs the whole rectangle.
std::string concentration_table(const FlowStatistics& p) {
  std::string text = fmt::format("time_s,{}_m,number_per_m,mass_kg_m\n", p.window().axis.letter());
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
           !find_solver_log(place).empty();
  };
  const fs::path inside = folder / "results" / "case";
  return !has_run(folder) && has_run(inside) ? inside : folder;
}

FlowReport analyse_flow(const fs::path& folder, const FlowOptions& options,
                        const FlowProgress& progress) {
  if (!(options.measures.average_s > 0.0 && std::isfinite(options.measures.average_s))) {
    throw InvalidInput("option --average", number_text(options.measures.average_s) + " s",
                       "above 0 s", "give the window of the moving average, such as 2e-3");
  }
  std::vector<fs::path> dumps;
  std::string no_dumps;
  try {
    dumps = list_dumps(folder);
  } catch (const InvalidInput& e) {
    no_dumps = e.what();
  }
  const FlowChannel channel =
      look_at_channel(folder, dumps.empty() ? DumpState{} : read_last_state(dumps.back()),
                      options.axis, options.probes);
  FlowReport report(options, window_of(channel, options));
  ParticleClock clock(folder, options.time_step_s);
  FlowObservables observables = make_flow_observables(report.window(), shape_of(channel));
  if (!dumps.empty()) {
    require_within(channel, options);
    read_particles(folder, dumps, clock, observables, report, progress);
    judge_particles(report);
  }
  read_gas(folder, report);
  if (!dumps.empty()) observe(folder, channel, clock, observables, report);
  if (dumps.empty() && !report.pressure) {
    throw InvalidInput("analysing " + folder.string(),
                       "neither particles in post/particles_*.dump nor pressure in Pa",
                       "the folder of a coupled run",
                       "give the folder in which the run happened; notes: " +
                           (report.notes.empty() ? "none" : report.notes.back()));
  }
  if (dumps.empty()) report.notes.push_back("no particles: " + no_dumps);
  report.cost = read_solver_cost(folder, options.from_s, options.log);
  if (!report.cost.wall_s_per_simulated_ms) {
    report.notes.push_back(
        report.cost.log.empty()
            ? "no wall clock: no log of powderFoam in the case; give --log FILE"
            : fmt::format("no wall clock: {} has no two times with ClockTime after --from",
                          report.cost.log.string()));
  } else if (report.cost.by_processor_time) {
    report.notes.push_back("the run is short: cost is processor time, not wall clock");
  }
  if (!report.cost.coupling_share_percent) {
    report.notes.push_back(
        "no coupling share: "
        "no log of powderFoam with a line `coupling share: X %`, which comes at the end of a run");
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
  j["window_s"] = report.options.measures.average_s;
  j["particle_velocity_mean_m_s"] = or_null(report.particles.velocity_mean_m_s());
  j["particle_velocity_std_m_s"] = or_null(report.particles.velocity_deviation_m_s());
  j["particle_count"] = or_null(report.particles.mean_particles());
  j["coupling_share_percent"] = or_null(report.cost.coupling_share_percent);
  j["wall_s_per_simulated_ms"] = or_null(report.cost.wall_s_per_simulated_ms);
  for (const FlowFindings& findings : report.findings) {
    for (const FlowNumber& number : findings.numbers) {
      j[number.key] = or_null(number.value);
      if (!number.value || !number.interval) continue;
      j[number.key] = {
          {"value", *number.value}, {"low", number.interval->from}, {"high", number.interval->to}};
    }
  }
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
  for (const FlowFindings& findings : report.findings) {
    tables.insert(tables.end(), findings.tables.begin(), findings.tables.end());
  }
  return tables;
}

}  // namespace powderlink::analysis
