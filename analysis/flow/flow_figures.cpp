// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/flow/flow_figures.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "base/gnuplot/gnuplot.h"
#include "base/invalid_input.h"

namespace powderlink::analysis {

namespace fs = std::filesystem;

namespace {

constexpr std::uint64_t kEnoughInSlice = 20;  // a percentile of a handful of particles says nothing

/// Slices with enough particles for percentiles.
std::size_t full_slices(const FlowStatistics& particles) {
  return static_cast<std::size_t>(
      std::count_if(particles.profile().begin(), particles.profile().end(),
                    [](const auto& slice) { return slice.second.up.count() >= kEnoughInSlice; }));
}

/// Why there is nothing that a figure could show; empty when there is.
std::string why_not(const std::string& name, const FlowReport& report) {
  const FlowStatistics& particles = report.particles;
  if (name == "pressure") {
    return report.pressure->probes.empty() ? "no probe has a value in the mesh from --from on" : "";
  }
  if (name == "solids_flow") {
    if (report.flow_kg_s.empty()) return "there is no solids flow";
    return report.flow_kg_s.size() < 2 ? "there is one dump only from --from on" : "";
  }
  if (name == "concentration") {
    std::set<long> slices;
    for (const auto& state : particles.states()) {
      for (const auto& [k, slice] : state.slices) slices.insert(k);
    }
    if (slices.empty()) return "no dump has a particle";
    if (slices.size() < 2)
      return "all particles are in one slice; give a smaller --slice-thickness";
    return particles.states().size() < 2 ? "there is one dump only" : "";
  }
  if (full_slices(particles) >= 2) return "";
  return fmt::format(
      "fewer than two slices of {:g} m hold {} particles or more; "
      "give another --slice-thickness, or an earlier --from",
      particles.window().slice_m, kEnoughInSlice);
}

}  // namespace

std::vector<std::string> draw_flow_figures(const FlowReport& report, const fs::path& out) {
  if (!have_gnuplot()) return {"no figures: gnuplot is not in PATH; install gnuplot-nox"};
  const FlowWindow& window = report.window();
  const FlowAxis& axis = window.axis;
  constexpr double kFar_m = 1e3;
  const std::string common = fmt::format(
      "slope={:.9g}; intercept={:.9g}; from_place={:.9g}; to_place={:.9g}; from_s={:.9g}; "
      "mean_flow={:.9g}; rms={:.9g}; average_ms={:g}; axis='{}'; across='{}'; up='{}'; enough={}",
      report.slope ? axis.way * report.slope->slope_Pa_m : 0.0,
      report.slope ? report.slope->intercept_Pa : 0.0,
      std::max(report.slope ? report.slope->from_m : window.from_m, -kFar_m),
      std::min(report.slope ? report.slope->to_m : window.to_m, kFar_m), window.from_s,
      report.mean_flow_kg_s.value_or(0.0),
      report.irregularity ? report.irregularity->rms_percent : -1.0,
      1e3 * report.options.measures.average_s, axis.letter(), "xyz"[axis.across()],
      "xyz"[axis.up()], kEnoughInSlice);
  std::vector<FlowFigure> figures;
  for (const char* name :
       {"pressure", "solids_flow", "height", "velocity", "width", "concentration"}) {
    if (!fs::is_regular_file(out / (std::string(name) + ".csv"))) continue;
    figures.push_back({name, "", why_not(name, report)});
  }
  for (const FlowFindings& findings : report.findings) {
    figures.insert(figures.end(), findings.figures.begin(), findings.figures.end());
  }
  std::vector<std::string> notes;
  for (const auto& [name, own, why] : figures) {
    const fs::path table = fs::absolute(out / (name + ".csv"));
    const fs::path svg = out / fmt::format("{}.svg", name);
    if (!why.empty()) {
      // That of another run of the command would not belong to the new table.
      std::error_code ignored;
      fs::remove(svg, ignored);
      notes.push_back(fmt::format("no figure {}: {}", name, why));
      continue;
    }
    draw_figure(svg, fmt::format("flow_{}.gp", name),
                fmt::format("{}; table={}{}{}", common, gnuplot_string(table.string()),
                            own.empty() ? "" : "; ", own),
                "give --no-figures");
  }
  return notes;
}

}  // namespace powderlink::analysis
