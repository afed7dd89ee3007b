// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/checks.h"

#include <fmt/format.h>

#include <cmath>

#include "models/invalid_input.h"

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
    const auto ask = [&](const char* unit, double as_um) {
      if (as_um >= kSmallest_um && as_um <= kLargest_um) {
        to_do = fmt::format("were {} given where micrometres are meant? write {:g}", unit, as_um);
        return true;
      }
      return false;
    };
    ask("metres", value * 1e6) || ask("nanometres", value * 1e-3) ||
        ask("values 1e6 times too large", value * 1e-6);
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

std::string adhesive_energy_warning(double adhesive_energy_J_m2, const std::string& where) {
  if (!(adhesive_energy_J_m2 > kDrySolids_J_m2)) return "";
  return fmt::format(
      "{}: an adhesive energy of {:.4g} J/m^2 is above 10 J/m^2; dry solids have 0.01 to 1. It is "
      "the "
      "work of adhesion of the interface (twice the surface energy for like solids, pull-off "
      "1.5 pi Gamma R), not a surface energy, and an instant stop asks for 100 to 1000 times more "
      "of "
      "it than a stop of 50 to 200 us",
      where, adhesive_energy_J_m2);
}

}  // namespace powderlink::analysis
