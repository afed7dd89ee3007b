// SPDX-License-Identifier: GPL-3.0-or-later
/// \file evidence_json.h
/// Results of compare and diagnose as JSON; keys in docs/reference.md.
/// Tests: tests/analysis/program/evidence_commands_test.cpp
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "analysis/evidence/comparison.h"
#include "analysis/evidence/diagnosis.h"

namespace powderlink::analysis {

nlohmann::ordered_json json_of(const Diagnosis& diagnosis, const Observations& observations);
/// \param backend  that made the predictions, "reduced" or "dem"
nlohmann::ordered_json json_of(const Comparison& comparison, const Observations& observations,
                               const std::string& backend);
nlohmann::ordered_json json_of(const std::vector<TrendTest>& tests);
nlohmann::ordered_json json_of_parameters(const Candidate& candidate);
/// null for what JSON cannot hold.
nlohmann::ordered_json json_number(double value);

}  // namespace powderlink::analysis
