// SPDX-License-Identifier: GPL-3.0-or-later
/// \file pvd.h
/// The list by which ParaView plays files as a series in time.
/// Tests: tests/analysis/render/series_test.cpp, tests/analysis/render/flow_test.cpp
#pragma once

#include <string>
#include <vector>

namespace powderlink::render {

struct PvdEntry {
  double time_s;
  std::string file;  ///< relative to the .pvd
};

std::string pvd_text(const std::vector<PvdEntry>& entries);

}  // namespace powderlink::render
