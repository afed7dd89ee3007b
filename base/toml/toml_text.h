// SPDX-License-Identifier: GPL-3.0-or-later
/// \file toml_text.h
/// Text as TOML has it. Tests: tests/analysis/kat/study_test.cpp
#pragma once

#include <string>

namespace powderlink {

/// In quotes, on one line whatever the text holds, so that it may stand in a comment too.
std::string quoted(const std::string& text);

}  // namespace powderlink
