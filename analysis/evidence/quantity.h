// SPDX-License-Identifier: GPL-3.0-or-later
/// \file quantity.h
/// How sentences, tables and figures name each kind of measurement.
/// Tests: tests/analysis/report/study_result_test.cpp, tests/analysis/evidence/retention_test.cpp
#pragma once

#include "analysis/kat/study/measurements.h"

namespace powderlink::analysis {

struct Quantity {
  KatRow::Kind kind;
  const char* name;    ///< in sentences
  const char* plural;  ///< in sentences
  const char* key;     ///< in names of files
  const char* unit;    ///< with its blank, as a terminal shows it
  const char* title;   ///< of the axis, in gnuplot's markup
};

inline const Quantity& quantity_of(KatRow::Kind kind) {
  static const Quantity list[] = {
      {KatRow::Kind::critical_diameter, "critical diameter", "critical diameters", "fit", " um",
       "critical diameter {/:Italic d}_c (µm)"},
      {KatRow::Kind::retained_share, "retained share", "retained shares", "fit_retained", "",
       "retained share"},
      {KatRow::Kind::residual_speed, "residual speed", "residual speeds", "fit_speed", " m/s",
       "residual speed (m/s)"}};
  for (const Quantity& q : list) {
    if (q.kind == kind) return q;
  }
  return list[0];
}

}  // namespace powderlink::analysis
