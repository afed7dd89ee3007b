// SPDX-License-Identifier: GPL-3.0-or-later
/// \file kat_runner.h
/// All rows of a study with LIGGGHTS, side by side on the cores, beside theory and reduced model.
/// Folders: OUT/row_01/round_1/ and so on. Errors: an exception that names the row; runs that are
/// finished stay and are reused next time.
/// Tests: tests/analysis/kat/kat_run_test.cpp
#pragma once

#include <vector>

#include "analysis/kat/dem/critical_search.h"
#include "analysis/kat/reduced/critical_diameter.h"
#include "analysis/kat/study/study.h"

namespace powderlink::analysis {

struct KatPoint {
  KatRow row;
  double adhesive_energy_J_m2 = 0.0;
  TheoryDiameter theory;
  CriticalDiameter reduced;
  SearchResult dem;
};

struct KatRunOptions {
  DropRunner runner;
  std::filesystem::path out;
  int jobs = 1;
  double resolution = 0.0;         ///< of d_c
  bool keep_all_pictures = false;  ///< else only those of every row's first run
};

std::vector<KatPoint> run_study(const Study& study, const std::vector<double>& adhesive_energy_J_m2,
                                const KatRunOptions& options);

}  // namespace powderlink::analysis
