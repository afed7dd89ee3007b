// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

#include "analysis/sizes/pictures/segmentation.h"

namespace powderlink::analysis {

namespace {

const cv::Scalar kWhole(51, 119, 238), kLeftOut(170, 119, 68);  // BGR of the figures' colours
constexpr int kLargestNumbered = 5000;                          // more numbers hide the picture

}  // namespace

std::string overlay_png(const Micrograph& micrograph, const Segmentation& found) {
  double least = 0.0, most = 0.0;
  cv::minMaxLoc(micrograph.grey, &least, &most);
  cv::Mat bytes, picture;
  micrograph.grey.convertTo(bytes, CV_8U, 255.0 / (most - least), -255.0 * least / (most - least));
  cv::cvtColor(bytes, picture, cv::COLOR_GRAY2BGR);

  int labels = 0;
  for (const auto* list : {&found.grains, &found.cut})
    for (const GrainShape& g : *list) labels = std::max(labels, g.label);
  std::vector<bool> whole(static_cast<std::size_t>(labels) + 1, false);
  for (const GrainShape& g : found.grains) whole[static_cast<std::size_t>(g.label)] = true;
  for (int r = 0; r < found.labels.rows; ++r) {
    for (int c = 0; c < found.labels.cols; ++c) {
      const int own = found.labels.at<int>(r, c);
      if (own == 0) continue;
      const auto differs = [&](int rr, int cc) {
        return rr < 0 || cc < 0 || rr >= found.labels.rows || cc >= found.labels.cols ||
               found.labels.at<int>(rr, cc) != own;
      };
      if (!differs(r - 1, c) && !differs(r + 1, c) && !differs(r, c - 1) && !differs(r, c + 1))
        continue;
      const bool counts = own <= labels && whole[static_cast<std::size_t>(own)];
      const cv::Scalar& colour = counts ? kWhole : kLeftOut;
      picture.at<cv::Vec3b>(r, c) =
          cv::Vec3b(cv::saturate_cast<uchar>(colour[0]), cv::saturate_cast<uchar>(colour[1]),
                    cv::saturate_cast<uchar>(colour[2]));
    }
  }
  int number = 0;
  for (const GrainShape& g : found.grains) {
    if (++number > kLargestNumbered) break;
    const std::string text = std::to_string(number);
    const double size = std::clamp(0.011 * std::sqrt(g.area_px), 0.28, 0.6);
    const cv::Size box = cv::getTextSize(text, cv::FONT_HERSHEY_SIMPLEX, size, 1, nullptr);
    const cv::Point at(static_cast<int>(g.x_px) - box.width / 2,
                       static_cast<int>(g.y_px) + box.height / 2);
    cv::putText(picture, text, at, cv::FONT_HERSHEY_SIMPLEX, size, cv::Scalar(255, 255, 255), 3,
                cv::LINE_AA);
    cv::putText(picture, text, at, cv::FONT_HERSHEY_SIMPLEX, size, cv::Scalar(26, 26, 26), 1,
                cv::LINE_AA);
  }
  std::vector<uchar> png;
  cv::imencode(".png", picture, png);
  return {png.begin(), png.end()};
}

}  // namespace powderlink::analysis
