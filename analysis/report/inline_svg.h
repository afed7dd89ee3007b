// SPDX-License-Identifier: GPL-3.0-or-later
/// \file inline_svg.h
/// An SVG drawing as part of a page: no XML prologue, as wide as its place, and its ids made its
/// own, so that several drawings of one program do not share their markers.
/// Tests: tests/analysis/report/page_test.cpp
#pragma once

#include <string>

namespace powderlink::analysis {

/// \param id  put before every id of the drawing: letters, digits, '-', '_'
std::string inline_svg(const std::string& svg, const std::string& id);

}  // namespace powderlink::analysis
