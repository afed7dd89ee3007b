// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/sizes/pictures/micrograph.h"

#include <fmt/format.h>

#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>
#include <set>

#include "analysis/sizes/picture_names.h"
#include "base/invalid_input.h"

namespace powderlink::analysis {

namespace {

constexpr int kSmallest = 32;  // pixels a side

double full_scale(const cv::Mat& picture) {
  switch (picture.depth()) {
    case CV_8U:
      return 255.0;
    case CV_16U:
      return 65535.0;
    default: {
      double least = 0.0, most = 0.0;
      cv::minMaxLoc(picture.reshape(1), &least, &most);
      return most > 0.0 ? most : 1.0;
    }
  }
}

}  // namespace

bool looks_like_picture(const std::filesystem::path& file) {
  static const std::set<std::string> tables = {".csv", ".tsv", ".txt", ".xls", ".dat"};
  if (has_picture_suffix(file)) return true;
  return tables.count(lower_suffix(file)) == 0 && std::filesystem::is_regular_file(file) &&
         cv::haveImageReader(file.string());
}

Micrograph read_micrograph(const std::filesystem::path& file) {
  Micrograph m;
  m.file = file.string();
  cv::Mat picture;
  try {
    picture = cv::imread(m.file, cv::IMREAD_UNCHANGED);
  } catch (const cv::Exception&) {
    picture.release();  // too large for OpenCV, or damaged
  }
  if (picture.empty()) {
    throw InvalidInput(
        "reading a micrograph", m.file, "a whole picture: PNG, TIFF, JPEG or BMP, 8 or 16 bit",
        "open it in a viewer and save it again; a table must end in .csv, .txt or .xls");
  }
  if (picture.cols < kSmallest || picture.rows < kSmallest) {
    throw InvalidInput(m.file, fmt::format("{} x {} pixels", picture.cols, picture.rows),
                       fmt::format("{0} x {0} pixels or more", kSmallest),
                       "give the picture as the microscope saved it");
  }
  const double scale = full_scale(picture);
  if (picture.depth() != CV_8U) m.notes.push_back(m.file + ": more than 8 bit, all are used");
  picture.convertTo(picture, CV_32F, 1.0 / scale);
  if (picture.channels() == 3 || picture.channels() == 4) {
    m.notes.push_back(m.file + ": colour picture, its luminance is used");
    cv::cvtColor(picture, m.grey,
                 picture.channels() == 3 ? cv::COLOR_BGR2GRAY : cv::COLOR_BGRA2GRAY);
  } else {
    cv::extractChannel(picture, m.grey, 0);
  }
  double least = 0.0, most = 0.0;
  cv::minMaxLoc(m.grey, &least, &most);
  if (!(most > least)) {
    throw InvalidInput(m.file, "one brightness everywhere", "grains on a background",
                       "give a picture with grains");
  }
  return m;
}

}  // namespace powderlink::analysis
