// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/kat/experiment/kat_analysis_figures.h"

#include <fmt/format.h>

#include "base/gnuplot/gnuplot.h"

namespace powderlink::analysis {

namespace fs = std::filesystem;

std::vector<std::string> draw_kat_analysis(const KatAnalysis& a, const fs::path& out) {
  if (!have_gnuplot()) return {"no figures: gnuplot is not in PATH; install gnuplot-nox"};
  const Estimate& d = a.retention.critical;
  const std::string common =
      fmt::format("d_c={:.9g}; d_low={:.9g}; d_high={:.9g}; table={}; curve={}", d.value, d.low,
                  d.high, gnuplot_string(fs::absolute(out / "retained.csv").string()),
                  gnuplot_string(fs::absolute(out / "retained_curve.csv").string()));
  draw_figure(out / "sizes.svg", "kat_sizes.gp", common, "give --no-figures");
  draw_figure(out / "retained.svg", "kat_retained.gp", common, "give --no-figures");
  return {};
}

}  // namespace powderlink::analysis
