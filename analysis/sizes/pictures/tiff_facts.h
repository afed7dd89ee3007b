// SPDX-License-Identifier: GPL-3.0-or-later
/// \file tiff_facts.h
/// What a TIFF says of itself beside its first picture: how many there are, and the scale.
///
///   Fiji, ImageJ   1/XResolution in the `unit` of its ImageDescription: um, micron, nm, mm, cm, inch
///   others         1/XResolution in ResolutionUnit, centimetre or inch
///
/// Per centimetre or inch it counts only where a pixel is smaller than 10 um: larger ones (72 or 300 per
/// inch) are those of a screen or printer.
///
/// Pages that repeat the picture at lower resolution do not count. ImageJ writes stacks above 4 GB as one
/// page and says `images=N`. Source: TIFF 6.0, sections 8 and 13; Fiji's files as its reader documents.
/// Errors: InvalidInput for pixels that are not square. Tests: tests/analysis/sizes/tiff_facts_test.cpp
#pragma once

#include <filesystem>
#include <optional>

namespace powderlink::analysis {

struct TiffFacts {
  int pictures = 1;
  std::optional<double> pixel_size_um{};
};

/// One picture without a scale for a file that is no TIFF, or that libtiff cannot open.
TiffFacts read_tiff_facts(const std::filesystem::path& file);

}  // namespace powderlink::analysis
