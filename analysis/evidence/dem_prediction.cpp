// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/evidence/dem_prediction.h"

#include "analysis/evidence/study_fit.h"

namespace powderlink::analysis {

std::vector<double> dem_predictions(const Study& study, const Candidate& fit,
                                    const KatRunOptions& options) {
  for (const KatRow& row : study.rows) {
    if (row.kind() == KatRow::Kind::critical_diameter) continue;
    throw InvalidInput("--backend dem", "a study with retained shares or residual speeds",
                       "critical diameters", "use --backend reduced for it");
  }
  std::error_code problem;
  std::filesystem::create_directories(options.out, problem);
  if (problem) {
    throw InvalidInput("folder of the runs", options.out.string(), "a folder that may be made",
                       problem.message() + "; name another one with --out");
  }
  const StudyFit values = with_values_of(study, fit);
  std::vector<double> predictions;
  for (const KatPoint& p : run_study(values.study, values.adhesive_energy_J_m2, options)) {
    double diameter = p.dem.critical_diameter_m;
    for (const auto& e : row_setup(values.study, p.row, p.adhesive_energy_J_m2).effects)
      diameter = e->observed_diameter_m(diameter);
    predictions.push_back(diameter * 1e6);
  }
  return predictions;
}

}  // namespace powderlink::analysis
