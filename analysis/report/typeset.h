// SPDX-License-Identifier: GPL-3.0-or-later
/// \file typeset.h
/// Text of the terminal as a page shows it: "chi^2", "um", "J/m^2" as χ², µm, J/m².
/// Tests: tests/analysis/report/page_test.cpp
#pragma once

#include <string>
#include <vector>

namespace powderlink::analysis {

std::string typeset(std::string text);

/// Typeset, with a capital (unless it begins with a name of the program) and a full stop.
std::string sentence(const std::string& text);

/// What is separated by "; ".
std::vector<std::string> parts(const std::string& text);

}  // namespace powderlink::analysis
