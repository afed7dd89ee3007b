// SPDX-License-Identifier: GPL-3.0-or-later
// draw_spheres OUT.png WIDTH HEIGHT MEDIAN_PX LOG_STD FRACTION TOUCHING LIGHT SEED
// A micrograph of drawn spheres, for the pictures of docs/particle_sizes.md and for measuring time.
#include <cstdio>
#include <cstdlib>
#include <opencv2/imgcodecs.hpp>

#include "tests/analysis/sizes/drawn_spheres.h"

int main(int argc, char** argv) {
  if (argc != 10) {
    std::fprintf(stderr,
                 "usage: %s OUT.png WIDTH HEIGHT MEDIAN_PX LOG_STD FRACTION TOUCHING LIGHT SEED\n",
                 argv[0]);
    return 2;
  }
  powderlink::analysis::Scene s;
  s.width = std::atoi(argv[2]);
  s.height = std::atoi(argv[3]);
  s.median_px = std::atof(argv[4]);
  s.log_std = std::atof(argv[5]);
  s.fraction = std::atof(argv[6]);
  s.touching = std::atof(argv[7]);
  s.light = std::atof(argv[8]);
  s.seed = static_cast<unsigned>(std::atoi(argv[9]));
  s.highlight = 0.3;
  const auto drawn = powderlink::analysis::draw(s);
  cv::Mat bytes;
  drawn.grey.convertTo(bytes, CV_8U, 255.0);
  if (!cv::imwrite(argv[1], bytes)) return 1;
  std::printf("%zu whole grains\n", drawn.whole.size());
  return 0;
}
