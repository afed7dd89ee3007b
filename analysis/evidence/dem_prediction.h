// SPDX-License-Identifier: GPL-3.0-or-later
/// \file dem_prediction.h
/// The predictions of a fit, made by LIGGGHTS instead of the reduced model. Runs are reused when
/// script and programs are the same, and go side by side (kat/dem/kat_runner.h).
/// Tests: tests/analysis/kat/kat_liggghts_test.cpp
#pragma once

#include <vector>

#include "analysis/evidence/candidate.h"
#include "analysis/kat/dem/kat_runner.h"

namespace powderlink::analysis {

/// d_c that would be read, one per row [um]; effects of the measurement are applied to what LIGGGHTS
/// finds. Makes the folder of the runs; errors as run_study().
std::vector<double> dem_predictions(const Study& study, const Candidate& fit,
                                    const KatRunOptions& options);

}  // namespace powderlink::analysis
