// SPDX-License-Identifier: GPL-3.0-or-later
/// \file tiff_files.h
/// TIFFs with the tags that Fiji and microscopes write.
#pragma once

#include <tiffio.h>

#include <filesystem>
#include <opencv2/core.hpp>
#include <string>

namespace powderlink::analysis {

struct TiffTags {
  std::string description;
  double x_resolution = 0.0, y_resolution = 0.0;  ///< 0: no tag; y as x
  int unit = 0;                                   ///< 0: no tag; RESUNIT_NONE, _INCH, _CENTIMETER
  int pages = 1;
  bool reduced = false;  ///< a last page that repeats the first one, smaller
};

/// As ImageJ does it for a pixel of this size in its unit.
inline TiffTags of_imagej(double pixel_size, const std::string& unit) {
  return {"ImageJ=1.54f\nunit=" + unit + "\nmin=0.0\nmax=255.0\n", 1.0 / pixel_size, 0.0,
          RESUNIT_NONE};
}

inline bool write_tiff(const std::filesystem::path& file, const cv::Mat& bytes, const TiffTags& t) {
  TIFF* tiff = TIFFOpen(file.c_str(), "w");
  if (tiff == nullptr) return false;
  bool whole = true;
  for (int page = 0; page < t.pages + (t.reduced ? 1 : 0); ++page) {
    TIFFSetField(tiff, TIFFTAG_IMAGEWIDTH, static_cast<uint32_t>(bytes.cols));
    TIFFSetField(tiff, TIFFTAG_IMAGELENGTH, static_cast<uint32_t>(bytes.rows));
    TIFFSetField(tiff, TIFFTAG_BITSPERSAMPLE, 8);
    TIFFSetField(tiff, TIFFTAG_SAMPLESPERPIXEL, 1);
    TIFFSetField(tiff, TIFFTAG_PHOTOMETRIC, PHOTOMETRIC_MINISBLACK);
    TIFFSetField(tiff, TIFFTAG_ROWSPERSTRIP, static_cast<uint32_t>(bytes.rows));
    if (page == t.pages) TIFFSetField(tiff, TIFFTAG_SUBFILETYPE, FILETYPE_REDUCEDIMAGE);
    if (!t.description.empty()) TIFFSetField(tiff, TIFFTAG_IMAGEDESCRIPTION, t.description.c_str());
    if (t.x_resolution > 0.0) {
      TIFFSetField(tiff, TIFFTAG_XRESOLUTION, t.x_resolution);
      TIFFSetField(tiff, TIFFTAG_YRESOLUTION,
                   t.y_resolution > 0.0 ? t.y_resolution : t.x_resolution);
    }
    if (t.unit != 0) TIFFSetField(tiff, TIFFTAG_RESOLUTIONUNIT, t.unit);
    for (int y = 0; y < bytes.rows; ++y) {
      cv::Mat row = bytes.row(y).clone();
      whole = TIFFWriteScanline(tiff, row.data, static_cast<uint32_t>(y), 0) == 1 && whole;
    }
    whole = TIFFWriteDirectory(tiff) == 1 && whole;
  }
  TIFFClose(tiff);
  return whole;
}

}  // namespace powderlink::analysis
