// SPDX-License-Identifier: GPL-3.0-or-later
/// \file kat_output.h
/// What `kat run` shows and stores: a table for the terminal, kat.json, kat.csv (d_c over v, for
/// figures) and particles.csv (residual speed over diameter, for figures).
/// Tests: tests/analysis/kat/kat_output_test.cpp
#pragma once

#include <string>
#include <vector>

#include "analysis/kat/dem/kat_runner.h"

namespace powderlink::analysis {

std::string kat_table(const std::vector<KatPoint>& points);
std::string kat_json(const std::vector<KatPoint>& points);
std::string kat_csv(const std::string& study_name, const std::vector<KatPoint>& points);
std::string particles_csv(const std::string& study_name, const std::vector<KatPoint>& points);

}  // namespace powderlink::analysis
