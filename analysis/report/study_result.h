// SPDX-License-Identifier: GPL-3.0-or-later
/// \file study_result.h
/// All that a report tells about one study: comparison, diagnosis, curve of the fit, and what
/// LIGGGHTS made of the same values.
/// Tests: tests/analysis/report/study_result_test.cpp
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "analysis/evidence/comparison.h"
#include "analysis/evidence/diagnosis.h"

namespace powderlink::analysis {

/// A file of `powderlink compare --backend dem --json`.
struct DemFile {
  std::filesystem::path file;
  std::vector<double> velocity_m_s, measured_um, model_um;
  std::vector<std::pair<std::string, double>> parameters;
};
/// Throws InvalidInput for a file that is something else.
DemFile read_dem_file(const std::filesystem::path& file);

struct DemResult {
  std::filesystem::path file;
  std::vector<double> model_um, residuals;  ///< one per row; in sigmas
  double rms_relative_error = 0.0;
};

class StudyResult {
 public:
  /// Reads, fits and judges. A study with too few rows to diagnose is compared only.
  StudyResult(const std::filesystem::path& file, bool with_diagnosis);
  StudyResult(const StudyResult&) = delete;  // fits refer to the study
  StudyResult& operator=(const StudyResult&) = delete;

  /// Takes the predictions if they belong to this study: same rows, same fitted values.
  bool take(const DemFile& dem);

  /// The study's effects, "a + b"; empty for the baseline.
  std::string effects() const;
  /// The best candidate and those that cannot be told from it, best first.
  std::vector<const Candidate*> leading() const;
  /// Standard deviation of the measurement alone, without what the model's form may be off.
  double measured_sigma(std::size_t row) const;

  const Study study;
  const Observations observations;
  const Comparison comparison;
  std::optional<Diagnosis> diagnosis;
  std::string no_diagnosis;  ///< why there is none
  PredictedCurve curve;      ///< of the study's own model; empty when rows differ in more than v
  std::optional<DemResult> dem;
};

}  // namespace powderlink::analysis
