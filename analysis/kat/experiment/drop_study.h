// SPDX-License-Identifier: GPL-3.0-or-later
/// \file drop_study.h
/// The study of several drops of one powder on one plate, grown drop by drop: STUDY.toml and beside it
/// STUDY.csv with a row of d_c and its standard deviation per drop, and the contact time where it was
/// measured. Its model is the baseline (instant stop): `diagnose` says what is missing, `add` adds it.
/// sigma = d_c ln(high/low)/(2*1.96), from the 95 % interval.
/// Errors: InvalidInput for a study of other materials, a table of other columns, a drop that is in
/// it already. Nothing is written then. Tests: tests/analysis/program/kat_analyse_command_test.cpp
#pragma once

#include <filesystem>

#include "analysis/kat/experiment/kat_analysis.h"

namespace powderlink::analysis {

/// What add_to_study() would write, after every check; both files by write_file().
class DropStudy {
 public:
  /// Reads what is there and appends the drop in memory.
  DropStudy(std::filesystem::path study, const KatAnalysis& analysis);

  void write() const;
  int rows() const { return rows_; }

 private:
  std::filesystem::path study_, table_;
  std::string study_text_, table_text_;
  int rows_ = 0;
};

}  // namespace powderlink::analysis
