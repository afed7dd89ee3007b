// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/sizes/pictures/two_levels.h"

#include <fmt/format.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>
#include <vector>

#include "base/invalid_input.h"

namespace powderlink::analysis {

namespace {

constexpr int kBackgroundDegree = 4, kGrainDegree = 2;
constexpr int kRounds = 5;
constexpr double kSamples = 60000;  // pixels that are fitted
constexpr double kEdge = 0.25;      // distance from the surfaces, in shares, where edges begin
constexpr double kApart = 4.0;      // of the scatter
constexpr double kDepths_px[] = {4.0, 3.0, 2.0};  // from the nearest pixel of the other class
constexpr std::size_t kFewestInside = 200;        // pixels that deep

double to_unit(int i, int n) { return 2.0 * (i + 0.5) / n - 1.0; }

int terms(int degree) { return (degree + 1) * (degree + 2) / 2; }

/// Chebyshev products up to a total degree; x and y from -1 to 1.
void basis(double x, double y, int degree, double* out) {
  double tx[kBackgroundDegree + 1] = {1.0, x}, ty[kBackgroundDegree + 1] = {1.0, y};
  for (int i = 2; i <= degree; ++i) {
    tx[i] = 2.0 * x * tx[i - 1] - tx[i - 2];
    ty[i] = 2.0 * y * ty[i - 1] - ty[i - 2];
  }
  for (int i = 0, k = 0; i <= degree; ++i)
    for (int j = 0; i + j <= degree; ++j) out[k++] = tx[i] * ty[j];
}

struct Sample {
  double x, y, value;
};

class Surface {
 public:
  explicit Surface(int degree) : degree_(degree), c_(Eigen::VectorXd::Zero(terms(degree))) {}

  /// Least squares with a slight pull of the shape to 0: a class may be absent in a corner.
  template <class Belongs>
  std::size_t fit(const std::vector<Sample>& samples, const Belongs& belongs) {
    const int k = terms(degree_);
    Eigen::MatrixXd normal = Eigen::MatrixXd::Zero(k, k);
    Eigen::VectorXd right = Eigen::VectorXd::Zero(k), b(k);
    std::size_t used = 0;
    for (const Sample& s : samples) {
      if (!belongs(s)) continue;
      basis(s.x, s.y, degree_, b.data());
      normal.selfadjointView<Eigen::Lower>().rankUpdate(b);
      right += s.value * b;
      ++used;
    }
    if (used == 0) return 0;
    constexpr double pull = 1e-5;
    for (int i = 1; i < k; ++i) normal(i, i) += pull * static_cast<double>(used);
    c_ = normal.selfadjointView<Eigen::Lower>().ldlt().solve(right);
    return used;
  }
  double operator()(double x, double y) const {
    double b[15];
    static_assert((kBackgroundDegree + 1) * (kBackgroundDegree + 2) / 2 <= 15);
    basis(x, y, degree_, b);
    double sum = 0.0;
    for (int i = 0; i < terms(degree_); ++i) sum += b[i] * c_[i];
    return sum;
  }
  /// The same along a row of the picture, where it is a polynomial of x alone.
  void along_row(double y, std::vector<double>& values) const {
    double of_y[kBackgroundDegree + 1] = {1.0, y}, of_x[kBackgroundDegree + 1] = {};
    for (int j = 2; j <= degree_; ++j) of_y[j] = 2.0 * y * of_y[j - 1] - of_y[j - 2];
    for (int i = 0, k = 0; i <= degree_; ++i)
      for (int j = 0; i + j <= degree_; ++j) of_x[i] += c_[k++] * of_y[j];
    const int cols = static_cast<int>(values.size());
    for (int c = 0; c < cols; ++c) {
      const double x = to_unit(c, cols);
      double after = 0.0, at = 0.0;  // Clenshaw's sum
      for (int i = degree_; i > 0; --i) {
        const double before = of_x[i] + 2.0 * x * at - after;
        after = at;
        at = before;
      }
      values[static_cast<std::size_t>(c)] = of_x[0] + x * at - after;
    }
  }

 private:
  int degree_;
  Eigen::VectorXd c_;
};

std::vector<Sample> samples_of(const cv::Mat& picture) {
  const int step =
      std::max(1, static_cast<int>(std::sqrt(static_cast<double>(picture.total()) / kSamples)));
  std::vector<Sample> samples;
  for (int r = step / 2; r < picture.rows; r += step)
    for (int c = step / 2; c < picture.cols; c += step)
      samples.push_back({to_unit(c, picture.cols), to_unit(r, picture.rows),
                         static_cast<double>(picture.at<float>(r, c))});
  return samples;
}

/// Otsu's threshold of what a smooth surface leaves.
double first_threshold(const std::vector<Sample>& samples, const Surface& trend) {
  cv::Mat rest(1, static_cast<int>(samples.size()), CV_32F);
  for (int i = 0; i < rest.cols; ++i) {
    const Sample& s = samples[static_cast<std::size_t>(i)];
    rest.at<float>(i) = static_cast<float>(s.value - trend(s.x, s.y));
  }
  double least = 0.0, most = 0.0;
  cv::minMaxLoc(rest, &least, &most);
  const double width = std::max(most - least, 1e-9);
  cv::Mat bytes;
  rest.convertTo(bytes, CV_8U, 255.0 / width, -255.0 * least / width);
  const double level = cv::threshold(bytes, bytes, 0, 255, cv::THRESH_OTSU);
  return least + (level + 0.5) * width / 255.0;
}

/// The two surfaces, and how far they are apart in units of the scatter around them.
struct TwoLevels {
  Surface background{kBackgroundDegree}, grains{kGrainDegree};
  bool bright = false;
  double apart = 0.0;

  /// 0 where the surfaces cross, in a corner without grains.
  double share(double background_there, double grains_there, double value) const {
    const double contrast = grains_there - background_there;
    const bool right = (contrast > 0.0) == bright && contrast != 0.0;
    return right ? (value - background_there) / contrast : 0.0;
  }
  double share(const Sample& s) const {
    return share(background(s.x, s.y), grains(s.x, s.y), s.value);
  }
  cv::Mat share(const cv::Mat& picture) const {
    cv::Mat result(picture.size(), CV_32F);
    std::vector<double> b(static_cast<std::size_t>(picture.cols)), f = b;
    for (int r = 0; r < picture.rows; ++r) {
      const double y = to_unit(r, picture.rows);
      background.along_row(y, b);
      grains.along_row(y, f);
      const float* from = picture.ptr<float>(r);
      float* to = result.ptr<float>(r);
      for (std::size_t c = 0; c < b.size(); ++c)
        to[c] = static_cast<float>(share(b[c], f[c], from[c]));
    }
    return result;
  }
};

TwoLevels fit_levels(const std::vector<Sample>& samples, GrainTone tone, int trend_degree) {
  TwoLevels t;
  Surface trend(trend_degree);
  trend.fit(samples, [](const Sample&) { return true; });
  const double split = first_threshold(samples, trend);
  const auto is_bright = [&](const Sample& s) { return s.value - trend(s.x, s.y) > split; };
  std::size_t bright = 0;
  for (const Sample& s : samples) bright += is_bright(s) ? 1 : 0;
  t.bright = tone == GrainTone::automatic ? 2 * bright < samples.size() : tone == GrainTone::bright;
  t.background.fit(samples, [&](const Sample& s) { return is_bright(s) != t.bright; });
  t.grains.fit(samples, [&](const Sample& s) { return is_bright(s) == t.bright; });
  std::vector<double> shares(samples.size());
  for (int round = 0; round < kRounds; ++round) {
    std::transform(samples.begin(), samples.end(), shares.begin(),
                   [&](const Sample& s) { return t.share(s); });
    std::size_t i = 0;
    t.background.fit(samples, [&](const Sample&) { return shares[i++] < kEdge; });
    i = 0;
    t.grains.fit(samples, [&](const Sample&) { return shares[i++] > 1.0 - kEdge; });
  }
  double square = 0.0, contrast = 0.0;
  for (const Sample& s : samples) {
    const double b = t.background(s.x, s.y), f = t.grains(s.x, s.y);
    const double off = std::min(std::fabs(s.value - b), std::fabs(s.value - f));
    square += off * off;
    contrast += (f - b) * (t.bright ? 1.0 : -1.0);
  }
  const auto n = static_cast<double>(samples.size());
  t.apart = square > 0.0 ? contrast / n / std::sqrt(square / n) : (contrast > 0.0 ? 1e9 : 0.0);
  return t;
}

/// Pixels of a class, deeper in it than the edge's blur reaches where there are enough of these.
std::vector<Sample> inside(const cv::Mat& picture, const cv::Mat& of_class) {
  cv::Mat depth;
  cv::distanceTransform(of_class, depth, cv::DIST_L2, cv::DIST_MASK_3, CV_32F);
  for (const double least : kDepths_px) {
    const cv::Mat deep = depth >= least;
    const auto count = static_cast<std::size_t>(cv::countNonZero(deep));
    if (count < kFewestInside) continue;
    const std::size_t step = 1 + count / static_cast<std::size_t>(kSamples);
    std::vector<Sample> samples;
    std::size_t i = 0;
    for (int r = 0; r < picture.rows; ++r) {
      const double y = to_unit(r, picture.rows);
      const auto* is_deep = deep.ptr<unsigned char>(r);
      for (int c = 0; c < picture.cols; ++c) {
        if (is_deep[c] != 0 && i++ % step == 0)
          samples.push_back(
              {to_unit(c, picture.cols), y, static_cast<double>(picture.at<float>(r, c))});
      }
    }
    return samples;
  }
  return {};
}

/// The levels anew from what is inside, without the edges.
cv::Mat share_between_insides(TwoLevels levels, const cv::Mat& picture, const cv::Mat& smoothed) {
  const cv::Mat share = levels.share(smoothed);
  const auto all = [](const Sample&) { return true; };
  const std::vector<Sample> background = inside(picture, share < 0.5),
                            grains = inside(picture, share > 0.5);
  if (background.empty() || grains.empty()) return share;
  levels.background.fit(background, all);
  levels.grains.fit(grains, all);
  return levels.share(smoothed);
}

}  // namespace

cv::Mat grain_share(const cv::Mat& picture, const cv::Mat& smoothed, GrainTone tone,
                    const std::string& name) {
  const std::vector<Sample> samples = samples_of(smoothed);
  // Light alone has one level around its trend. Beyond that, a few large grains look like light and
  // strong light like grains: the start that parts them best is taken.
  TwoLevels best = fit_levels(samples, tone, kGrainDegree);
  if (!(best.apart > kApart)) {
    throw InvalidInput(
        name,
        fmt::format(
            "no grains to be seen: the two brightnesses differ by {:.2g} times their scatter",
            best.apart),
        fmt::format("more than {:g} times: grains of one tone on a background of another", kApart),
        "give --grains bright or dark, "
        "a picture with more contrast, or --crop-bottom when it has a legend");
  }
  for (const int degree : {0, 1}) {
    TwoLevels other = fit_levels(samples, tone, degree);
    if (other.apart > best.apart) best = other;
  }
  return share_between_insides(best, picture, smoothed);
}

}  // namespace powderlink::analysis
