// SPDX-License-Identifier: GPL-3.0-or-later
#include "liggghts_styles/kat_drop/kat_drop_options.h"

#include <cmath>
#include <fstream>
#include <limits>
#include <sstream>

#include "liggghts_styles/host/argument_words.h"
#include "liggghts_styles/kat_drop/kat_population.h"

namespace powderlink::host {

namespace {

const char* const kKeywords =
    "wall, plate, velocity, fall, stop, rebound, frame, gravity, settle, watch, populate, results";

physics::StopPulse measured_stop(const std::string& file, double rebound) {
  std::ifstream in(file);
  if (!in) {
    throw InvalidInput("stop file", file, "a readable file of time [s] and deceleration [m/s^2]",
                       "check the path (it is relative to where LIGGGHTS runs)");
  }
  std::vector<double> times, values;
  std::string line;
  for (int row = 1; std::getline(in, line); ++row) {
    const std::string text = line.substr(0, line.find('#'));
    if (text.find_first_not_of(" \t\r") == std::string::npos) continue;
    std::istringstream words(text);
    double t = 0.0, a = 0.0;
    if (words >> t >> a) {
      times.push_back(t);
      values.push_back(a);
      continue;
    }
    throw InvalidInput("stop file " + file + ", line " + std::to_string(row), line,
                       "two numbers: time [s], deceleration [m/s^2]", "correct the line");
  }
  return physics::StopPulse::measured(times, values, rebound);
}

std::vector<double> parse_sizes(Words& words) {
  const std::string allowed =
      "range DMIN DMAX N | list N D1 ... | rosinrammler X0 N DMIN DMAX COUNT SEED";
  if (words.next("populate", "sizes") != "sizes") {
    throw InvalidInput("populate", "no keyword 'sizes'", "type T density RHO sizes ...",
                       "name the sizes after the density");
  }
  const std::string kind = words.next("populate sizes", allowed);
  const auto ordered = [](double low, double high) {
    if (!(low <= high)) {
      throw InvalidInput("populate sizes", number_text(low) + " .. " + number_text(high) + " m",
                         "smallest diameter first", "exchange the two");
    }
  };
  if (kind == "range") {
    const double low = words.positive("populate sizes range: smallest diameter");
    const double high = words.positive("populate sizes range: largest diameter");
    ordered(low, high);
    return graded_diameters(low, high, words.count("populate sizes range: number", 1));
  }
  if (kind == "list") {
    std::vector<double> d(words.count("populate sizes list: number", 1));
    for (double& x : d) x = words.positive("populate sizes list: diameter");
    return d;
  }
  if (kind == "rosinrammler") {
    const double x0 = words.positive("populate sizes rosinrammler: x0");
    const double exponent = words.positive("populate sizes rosinrammler: exponent");
    const double low = words.positive("populate sizes rosinrammler: smallest diameter");
    const double high = words.positive("populate sizes rosinrammler: largest diameter");
    ordered(low, high);
    const int n = words.count("populate sizes rosinrammler: number", 1);
    return rosin_rammler_diameters(x0, exponent, low, high, n,
                                   words.count("populate sizes rosinrammler: seed", 0));
  }
  throw InvalidInput("populate sizes", kind, allowed, "name one of them");
}

}  // namespace

KatDropOptions KatDropOptions::parse(int narg, const char* const* arg) {
  KatDropOptions o;
  Words words(narg, arg);
  std::string stop = "instant";
  std::string stop_file;
  double tau = 0.0;
  double rebound = 0.0;
  bool plate_given = false;
  while (words.more()) {
    const std::string key = words.next("keyword", kKeywords);
    if (key == "wall") {
      o.wall_id = words.next("wall", "ID of a fix wall/gran");
    } else if (key == "plate") {
      const std::string plane = words.next("plate", "xplane | yplane | zplane");
      if (plane != "xplane" && plane != "yplane" && plane != "zplane") {
        throw InvalidInput("plate", plane, "xplane | yplane | zplane",
                           "name the plane of the wall");
      }
      o.axis = plane[0] - 'x';
      o.plate_position = words.number("plate coordinate", -1e3, 1e3, "metres");
      plate_given = true;
    } else if (key == "fall") {
      const std::string way = words.next("fall", "-x +x -y +y -z +z");
      if (way.size() != 2 || (way[0] != '-' && way[0] != '+') || way[1] < 'x' || way[1] > 'z') {
        throw InvalidInput("fall", way, "-x +x -y +y -z +z",
                           "name the direction in which grains leave");
      }
      o.direction = way[0] == '-' ? -1.0 : 1.0;
      if (way[1] - 'x' != o.axis) {
        throw InvalidInput("fall", way, "along the normal of the plate", "name the plate first");
      }
    } else if (key == "velocity") {
      o.velocity_m_s = words.number("velocity", std::numeric_limits<double>::min(), 1e3,
                                    "impact speed above 0 and up to 1000 m/s");
    } else if (key == "stop") {
      o.stop_given = true;
      stop = words.next("stop", "instant | halfsine TAU | hertz TAU | file FILE");
      if (stop == "halfsine" || stop == "hertz") {
        tau = words.positive("stop duration");
      } else if (stop == "file") {
        stop_file = words.next("stop file", "a file name");
      } else if (stop != "instant") {
        throw InvalidInput("stop", stop, "instant | halfsine TAU | hertz TAU | file FILE",
                           "name one of them");
      }
    } else if (key == "rebound") {
      rebound = words.number("rebound", 0.0, 1.0, "0 to 1");
    } else if (key == "frame") {
      const std::string frame = words.next("frame", "plate | moving");
      if (frame != "plate" && frame != "moving") {
        throw InvalidInput("frame", frame, "plate | moving", "name one of them");
      }
      o.moving_frame = frame == "moving";
    } else if (key == "gravity") {
      o.gravity_m_s2 = words.number("gravity", 0.0, 1e3, "0 to 1000 m/s^2, along the fall");
    } else if (key == "settle") {
      o.settle_limit_s = words.positive("settle time");
    } else if (key == "watch") {
      o.watch_s = words.positive("watch time");
    } else if (key == "populate") {
      if (words.next("populate", "type") != "type") {
        throw InvalidInput("populate", "no keyword 'type'", "type T density RHO sizes ...",
                           "start with type");
      }
      o.populate_type = words.count("populate type", 1);
      if (words.next("populate", "density") != "density") {
        throw InvalidInput("populate", "no keyword 'density'", "type T density RHO sizes ...",
                           "name the density after the type");
      }
      o.density_kg_m3 = words.positive("populate density");
      o.diameters_m = parse_sizes(words);
    } else if (key == "results") {
      o.results_file = words.next("results", "a file name");
    } else {
      throw InvalidInput("keyword of fix kat/drop", key, kKeywords, "correct the spelling");
    }
  }
  if (o.wall_id.empty() || !plate_given || o.velocity_m_s == 0.0) {
    throw InvalidInput("fix kat/drop", "a line without wall, plate or velocity",
                       "wall WALL-ID plate zplane COORDINATE velocity V [...]",
                       "complete the line");
  }
  if (stop == "instant") o.stop = physics::StopPulse::instant(rebound);
  if (stop == "halfsine") o.stop = physics::StopPulse::half_sine(tau, rebound);
  if (stop == "hertz") o.stop = physics::StopPulse::hertz(tau, rebound);
  if (stop == "file") o.stop = measured_stop(stop_file, rebound);
  return o;
}

}  // namespace powderlink::host
