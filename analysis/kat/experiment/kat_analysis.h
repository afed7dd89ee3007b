// SPDX-License-Identifier: GPL-3.0-or-later
/// \file kat_analysis.h
/// One drop from its grains before and after to d_c and Gamma: what `powderlink kat analyse` prints.
/// Tests: tests/analysis/program/kat_analyse_command_test.cpp, tests/analysis/kat/gamma_methods_test.cpp
#pragma once

#include <string>
#include <vector>

#include "analysis/kat/experiment/gamma_method.h"
#include "analysis/kat/experiment/retention_analysis.h"

namespace powderlink::analysis {

struct KatAnalysisInput {
  std::vector<double> before_um, after_um;
  KatDrop drop;  ///< without d_c
  // Standard deviations; 0: taken as exact.
  double velocity_sigma_m_s = 0.0, contact_time_sigma_s = 0.0, deceleration_sigma_m_s2 = 0.0;
  RetentionOptions retention;
  double digits_um2 = 0.0;  ///< a diameter d is known to +-digits_um2/d (grain_files.h)
};

struct MethodResult {
  const GammaMethodInfo* info = nullptr;
  std::optional<GammaEstimate> gamma;  ///< empty: what it needs was not given
};

struct KatAnalysis {
  UncertainDrop drop;
  RetentionAnalysis retention;
  std::vector<MethodResult> methods;
  std::vector<std::string> warnings;
};

KatAnalysis analyse_kat(const KatAnalysisInput& input);

/// d_c and what else is uncertain, each at both ends of its 95 % interval.
UncertainDrop uncertain_drop(const KatAnalysisInput& input, const Estimate& critical_um);

std::vector<MethodResult> all_methods(const UncertainDrop& drop);

/// Which methods contradict each other: their 95 % intervals do not meet.
std::vector<std::string> disagreements(const std::vector<MethodResult>& methods);

}  // namespace powderlink::analysis
