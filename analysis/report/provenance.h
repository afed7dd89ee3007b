// SPDX-License-Identifier: GPL-3.0-or-later
/// \file provenance.h
/// Where a report comes from: programs with versions, inputs with fingerprints, command, date.
/// SOURCE_DATE_EPOCH of the environment replaces the clock. Tests: tests/analysis/report/browser_test.sh
#pragma once

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace powderlink::analysis {

using Facts = std::vector<std::pair<std::string, std::string>>;

/// \param inputs  files with their SHA-1
Facts provenance(const std::string& version, const std::vector<std::filesystem::path>& inputs);

/// 2026-01-31 12:00:00 UTC
std::string date_text();

}  // namespace powderlink::analysis
