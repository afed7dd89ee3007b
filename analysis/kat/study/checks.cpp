// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/kat/study/checks.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/invalid_input.h"

namespace powderlink::analysis {

namespace {

constexpr double kLargestVelocity_m_s = 1000.0;
constexpr double kSmallest_um = 0.01;
constexpr double kLargest_um = 1e4;
constexpr double kSmallest_us = 0.01;
constexpr double kLargest_us = 1e5;
constexpr double kDrySolids_J_m2 = 10.0;  // work of adhesion; 0.01 to 1 is usual

std::string number(double value) { return fmt::format("{:g}", value); }

}  // namespace

double require_velocity_m_s(double value, const std::string& where) {
  if (!(value > 0.0 && value < kLargestVelocity_m_s)) {
    throw InvalidInput(
        where + ": impact velocity", number(value) + " m/s", "> 0 and below 1000 m/s",
        value > 0.0 ? "was mm/s meant? divide by 1000"
                    : "give the speed at which the plate meets the anvil, such as 1.4");
  }
  return value;
}

double require_diameter_um(double value, const std::string& where) {
  if (!(value >= kSmallest_um && value <= kLargest_um)) {
    std::string to_do = "give the diameter in micrometres, such as 46";
    struct Guess {
      const char* what;
      double in_um;
    };
    constexpr Guess guesses[] = {{"metres", 1e6},
                                 {"millimetres", 1e3},
                                 {"nanometres", 1e-3},
                                 {"values 1e6 times too large", 1e-6}};
    // 6.6 um may be 0.0066 mm or 6600 um 0.0066 m: powders first.
    bool found = false;
    for (const auto& [low, high] : {std::pair(kUsualDiameter.low, kUsualDiameter.high),
                                    std::pair(kSmallest_um, kLargest_um)}) {
      for (const Guess& g : guesses) {
        const double as_um = value * g.in_um;
        if (found || !(as_um >= low && as_um <= high)) continue;
        to_do = fmt::format("were {} given where micrometres are meant? write {:g}", g.what, as_um);
        found = true;
      }
    }
    throw InvalidInput(where + ": diameter", number(value) + " um", "0.01 to 10000 um", to_do);
  }
  return value;
}

double require_contact_time_us(double value, const std::string& where) {
  if (!(value >= kSmallest_us && value <= kLargest_us)) {
    const double as_seconds = value * 1e6;
    const bool seconds = as_seconds >= kSmallest_us && as_seconds <= kLargest_us;
    throw InvalidInput(
        where + ": contact time", number(value) + " us", "0.01 to 100000 us",
        seconds ? "were seconds given where microseconds are meant? write " + number(as_seconds)
                : "give the time in microseconds, such as 100");
  }
  return value;
}

double require_adhesive_energy_J_m2(double value, const std::string& where) {
  if (!(value > 0.0 && std::isfinite(value))) {
    throw InvalidInput(where + ": adhesive energy", number(value) + " J/m^2", "> 0 J/m^2",
                       "give the work of adhesion of the interface, 0.01 to 1 for dry solids");
  }
  return value;
}

std::string unit_question(std::vector<double> values, const UsualRange& usual) {
  if (values.empty()) return "";
  std::sort(values.begin(), values.end());
  const bool small = values.back()<usual.low, large = values.front()> usual.high;
  const double factor = small ? 1e3 : 1e-3;
  const double middle = values[values.size() / 2];
  if ((!small && !large) || factor * middle < usual.low || factor * middle > usual.high) return "";
  return fmt::format(
      "all values are {} {:g} {}: were {} given where {} are meant? then write {:g} for {:g}",
      small ? "below" : "above", small ? usual.low : usual.high, usual.unit,
      small ? usual.larger_unit : usual.smaller_unit, usual.unit, factor * middle, middle);
}

std::string mixed_unit_question(std::vector<double> values, const UsualRange& usual) {
  constexpr double thousand = 1e3;
  constexpr double gap = 50.0;   // between the two units
  constexpr double among = 2.0;  // a value may lie so far beyond the others
  if (values.size() < 2) return "";
  std::sort(values.begin(), values.end());
  const auto wider = [](double a, double b) { return b / a > gap; };
  const auto below = std::adjacent_find(values.begin(), values.end(), wider);
  if (below == values.end()) return "";
  const double low = values.front(), small = *below, large = *(below + 1), high = values.back();
  if (thousand * low * among < large || thousand * small > among * high) return "";
  const bool small_wrong = small < usual.low || high <= usual.high;
  return fmt::format(
      "values from {:g} to {:g} beside {:g} to {:g} {}: "
      "were {} given in some rows where {} are meant? then write {:g} for {:g}",
      low, small, large, high, usual.unit, small_wrong ? usual.larger_unit : usual.smaller_unit,
      usual.unit, small_wrong ? thousand * small : large / thousand, small_wrong ? small : large);
}

std::string adhesive_energy_warning(double adhesive_energy_J_m2, const std::string& where) {
  if (!(adhesive_energy_J_m2 > kDrySolids_J_m2)) return "";
  return fmt::format(
      "{}: an adhesive energy of {:.4g} J/m^2 is above 10 J/m^2; dry solids have 0.01 to 1. "
      "It is the work of adhesion of the interface (twice the surface energy for like solids, "
      "pull-off 1.5 pi Gamma R), not a surface energy, "
      "and an instant stop asks for 100 to 1000 times more of it than a stop of 50 to 200 us",
      where, adhesive_energy_J_m2);
}

}  // namespace powderlink::analysis
