// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/flow/flow_figures.h"

#include <fmt/format.h>

#include <algorithm>

#include "analysis/gnuplot.h"

namespace powderlink::analysis {

namespace fs = std::filesystem;

std::vector<std::string> draw_flow_figures(const FlowReport& report, const fs::path& out) {
  if (!have_gnuplot()) return {"no figures: gnuplot is not in PATH; install gnuplot-nox"};
  const FlowWindow& window = report.options.window;
  const std::string common = fmt::format(
      "slope={:.9g}; intercept={:.9g}; from_z={:.9g}; to_z={:.9g}; from_s={:.9g}; "
      "mean_flow={:.9g}; rms={:.9g}; average_ms={:g}",
      report.slope ? report.slope->slope_Pa_m : 0.0,
      report.slope ? report.slope->intercept_Pa : 0.0, window.from_z_m,
      std::min(window.to_z_m, 1e3), window.from_s, report.mean_flow_kg_s.value_or(0.0),
      report.irregularity ? report.irregularity->rms_percent : -1.0,
      1e3 * report.options.average_s);
  for (const char* name :
       {"pressure", "solids_flow", "height", "velocity", "width", "concentration"}) {
    const fs::path table = fs::absolute(out / (std::string(name) + ".csv"));
    if (!fs::is_regular_file(table)) continue;
    draw_figure(out / fmt::format("{}.svg", name), fmt::format("flow_{}.gp", name),
                fmt::format("{}; table={}", common, gnuplot_string(table.string())),
                "give --no-figures");
  }
  return {};
}

}  // namespace powderlink::analysis
