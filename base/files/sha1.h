// SPDX-License-Identifier: GPL-3.0-or-later
/// \file sha1.h
/// The fingerprint of a text. Tests: tests/base/gnuplot_test.cpp
#pragma once

#include <string>

namespace powderlink {

/// 40 hexadecimal digits, as `sha1sum` prints them.
std::string sha1(const std::string& text);

}  // namespace powderlink
