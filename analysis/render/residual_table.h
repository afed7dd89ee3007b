// SPDX-License-Identifier: GPL-3.0-or-later
/// \file residual_table.h
/// kat_results.json as columns that gnuplot reads.
/// Tests: tests/analysis/render/series_test.cpp
#pragma once

#include <string>

#include "analysis/render/run_directory.h"

namespace powderlink::render {

/// Two comment lines `# impact_velocity_m_s V` and `# critical_diameter_um D`, a header line, and
/// diameter_um,attached,speed_m_s for every particle by size. Refuses results without particles.
/// \param source  folder of the results, for messages
std::string residual_table(const RunResults& results, const std::string& source);

}  // namespace powderlink::render
