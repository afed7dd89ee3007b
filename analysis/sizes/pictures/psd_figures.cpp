// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/sizes/pictures/psd_figures.h"

#include <fmt/format.h>

#include "base/gnuplot/gnuplot.h"

namespace powderlink::analysis {

std::vector<std::string> draw_psd_figures(const PsdReport& r, const std::filesystem::path& out) {
  if (!have_gnuplot()) return {"no figures: gnuplot is not in PATH; install gnuplot-nox"};
  const auto fitted = [](const char* name, const std::optional<RosinRammlerFit>& fit) {
    const bool fits = fit && fit->fits();
    return fmt::format("{0}_x0={1:.6g}; {0}_n={2:.6g}; {0}_r2={3:.6g}", name,
                       fits ? fit->law.x0_um : -1.0, fits ? fit->law.n : 0.0,
                       fits ? fit->r_squared : 0.0);
  };
  const std::string common = fmt::format(
      "{}; {}; d50_number={:.6g}; d50_mass={:.6g}; grains={}; smallest={:.9g}; largest={:.9g}",
      fitted("number", r.rr_number), fitted("mass", r.rr_mass), r.by_number[1].value,
      r.by_mass[1].value, r.set.particles.size(), r.number->diameters_um().front(),
      r.number->diameters_um().back());
  const std::pair<const char*, const char*> figures[] = {{"distribution", "distribution.csv"},
                                                         {"histogram", "histogram.csv"},
                                                         {"shape", "particles.csv"}};
  for (const auto& [name, table] : figures) {
    draw_figure(out / fmt::format("{}.svg", name), fmt::format("psd_{}.gp", name),
                fmt::format("{}; table={}", common,
                            gnuplot_string(std::filesystem::absolute(out / table).string())),
                "give --no-figures");
  }
  return {};
}

}  // namespace powderlink::analysis
