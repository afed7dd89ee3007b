// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/sizes/pictures/tiff_facts.h"

#include <fmt/format.h>
#include <tiffio.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <map>
#include <memory>
#include <sstream>
#include <string>

#include "base/invalid_input.h"

namespace powderlink::analysis {

namespace {

constexpr double kPrinter_um = 10.0;  // 2540 per inch
constexpr double kSquare = 1e-3;      // relative
constexpr double kCentimetre_um = 1e4, kInch_um = 25400.0;

struct Close {
  void operator()(TIFF* tiff) const { TIFFClose(tiff); }
};

/// libtiff tells of unknown tags, which makers of microscopes use, on stderr.
class Quiet {
 public:
  Quiet() : warnings_(TIFFSetWarningHandler(nullptr)), errors_(TIFFSetErrorHandler(nullptr)) {}
  ~Quiet() {
    TIFFSetWarningHandler(warnings_);
    TIFFSetErrorHandler(errors_);
  }
  Quiet(const Quiet&) = delete;
  Quiet& operator=(const Quiet&) = delete;

 private:
  TIFFErrorHandler warnings_, errors_;
};

bool begins_as_tiff(const std::filesystem::path& file) {
  char first[4] = {};
  std::ifstream(file, std::ios::binary).read(first, sizeof(first));
  const std::string begin(first, sizeof(first));
  return begin == std::string("II*\0", 4) || begin == std::string("MM\0*", 4) ||
         begin == std::string("II+\0", 4) || begin == std::string("MM\0+", 4);
}

/// The value after `key=` on a line of its own of ImageJ's description.
std::string described(const std::string& description, const std::string& key) {
  std::istringstream lines(description);
  for (std::string line; std::getline(lines, line);) {
    if (line.compare(0, key.size() + 1, key + "=") != 0) continue;
    while (!line.empty() && (line.back() == '\r' || line.back() == ' ')) line.pop_back();
    return line.substr(key.size() + 1);
  }
  return "";
}

/// In um; nothing for pixels and what is unknown.
std::optional<double> length_um(const std::string& unit) {
  static const std::map<std::string, double> lengths = {
      {"um", 1.0},         {"\xC2\xB5m", 1.0}, {"\xCE\xBCm", 1.0}, {"\xB5m", 1.0},
      {"\\u00B5m", 1.0},   {"micron", 1.0},    {"microns", 1.0},   {"micrometer", 1.0},
      {"micrometre", 1.0}, {"nm", 1e-3},       {"mm", 1e3},        {"cm", kCentimetre_um},
      {"m", 1e6},          {"inch", kInch_um}};
  const auto found = lengths.find(unit);
  return found == lengths.end() ? std::nullopt : std::optional<double>(found->second);
}

std::string description_of(TIFF* tiff) {
  const char* text = nullptr;
  return TIFFGetField(tiff, TIFFTAG_IMAGEDESCRIPTION, &text) != 0 && text != nullptr ? text : "";
}

/// The unit of the resolution [um].
std::optional<double> unit_um(TIFF* tiff) {
  uint16_t unit =
      RESUNIT_NONE;  // absent: not the inch of the standard, ImageJ's description counts
  TIFFGetField(tiff, TIFFTAG_RESOLUTIONUNIT, &unit);
  const std::string description = description_of(tiff);
  const auto said = description.compare(0, 7, "ImageJ=") == 0
                        ? length_um(described(description, "unit"))
                        : std::nullopt;
  // As ImageJ reads it: per centimetre, even where its description has um.
  if (unit == RESUNIT_CENTIMETER) return kCentimetre_um;
  if (unit == RESUNIT_INCH) return kInch_um;
  return said;
}

std::optional<double> pixel_size_um(TIFF* tiff, const std::string& file) {
  float x = 0.0F, y = 0.0F;
  if (TIFFGetField(tiff, TIFFTAG_XRESOLUTION, &x) == 0 || !std::isfinite(x) || !(x > 0.0F))
    return std::nullopt;
  const auto unit = unit_um(tiff);
  if (!unit) return std::nullopt;
  const double size_um = *unit / static_cast<double>(x);
  const bool of_print = *unit == kCentimetre_um || *unit == kInch_um;
  if (of_print && !(size_um < kPrinter_um)) return std::nullopt;
  if (TIFFGetField(tiff, TIFFTAG_YRESOLUTION, &y) != 0 &&
      !(std::fabs(y - x) <= static_cast<float>(kSquare) * x)) {
    throw InvalidInput(file + ", scale of the TIFF",
                       fmt::format("{:g} pixels per unit across, {:g} down", x, y), "square pixels",
                       "correct it in Fiji, Image > Properties");
  }
  return size_um;
}

int pictures_in(TIFF* tiff) {
  int pages = 0;
  do {
    uint32_t kind = 0;
    TIFFGetFieldDefaulted(tiff, TIFFTAG_SUBFILETYPE, &kind);
    if ((kind & FILETYPE_REDUCEDIMAGE) == 0U) ++pages;
  } while (TIFFReadDirectory(tiff) == 1);
  TIFFSetDirectory(tiff, 0);
  const std::string description = description_of(tiff);
  const bool by_imagej = description.compare(0, 7, "ImageJ=") == 0;
  const int said = by_imagej ? std::atoi(described(description, "images").c_str()) : 1;
  return std::max({1, pages, said});
}

}  // namespace

TiffFacts read_tiff_facts(const std::filesystem::path& file) {
  TiffFacts facts;
  if (!begins_as_tiff(file)) return facts;
  const Quiet quiet;
  const std::unique_ptr<TIFF, Close> tiff(TIFFOpen(file.c_str(), "r"));
  if (!tiff) return facts;
  facts.pictures = pictures_in(tiff.get());
  facts.pixel_size_um = pixel_size_um(tiff.get(), file.string());
  return facts;
}

}  // namespace powderlink::analysis
