// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/kat/device/device_velocity.h"

#include <fmt/format.h>

#include <cmath>

#include "base/invalid_input.h"
#include "kat_firmware/core/kat_velocity.h"

namespace powderlink::analysis {

namespace {

constexpr double kGravity_m_s2 = kat::kGravity_um_s2 * 1e-6;
constexpr double kAlarm_sigmas = 3.0;

double root_of_squares(double a, double b, double c) { return std::sqrt(a * a + b * b + c * c); }

}  // namespace

DeviceVelocity device_velocity(const kat::Drop& drop, const DeviceSigmas& sigmas,
                               const std::string& where) {
  const double g = kGravity_m_s2;
  const double h = drop.carrier_um * 1e-6;
  const double length = drop.beam_um * 1e-6;
  // Differences on the device's 32-bit clock.
  const double t = static_cast<uint32_t>(drop.leave_us - drop.enter_us) * 1e-6;
  const double enters = h / t - 0.5 * g * t;
  if (!(h > 0.0 && length >= h && t > 0.0 && enters >= 0.0)) {
    throw InvalidInput(
        where + ": beam times",
        fmt::format("{} us blocked by {} um, beam {} um above the anvil", std::lround(t * 1e6),
                    drop.carrier_um, drop.beam_um),
        "a free fall: beam_um >= carrier_um > 0, and faster than from rest at the beam",
        "correct carrier_um and beam_um of the device, or drop again");
  }
  const double sigma_h = sigmas.carrier_um * 1e-6;
  const double sigma_length = sigmas.beam_um * 1e-6;
  const double sigma_t = std::sqrt(2.0) * sigmas.edge_us * 1e-6;
  const double w = h / t + 0.5 * g * t;
  DeviceVelocity v;
  v.value_m_s = std::sqrt(w * w + 2.0 * g * (length - h));
  v.sigma_m_s = root_of_squares((w / t - g) * sigma_h, g * sigma_length,
                                w * (0.5 * g - h / (t * t)) * sigma_t) /
                v.value_m_s;

  const bool vibration = drop.vibration_us != kat::kNoValue;
  const uint32_t touch_us = vibration ? drop.vibration_us - drop.latency_us : drop.touch_us;
  const double flight = static_cast<uint32_t>(touch_us - drop.leave_us) * 1e-6;
  if (length > h && flight > 0.0) {
    const double s = length - h;
    v.flight_m_s = s / flight + 0.5 * g * flight;
    const double sigma_flight =
        std::hypot(sigmas.edge_us, vibration ? sigmas.latency_us : sigmas.edge_us) * 1e-6;
    v.flight_sigma_m_s = root_of_squares(sigma_length / flight, sigma_h / flight,
                                         (0.5 * g - s / (flight * flight)) * sigma_flight);
    v.consistent = std::abs(*v.flight_m_s - v.value_m_s) <=
                   kAlarm_sigmas * (v.sigma_m_s + *v.flight_sigma_m_s);
  }
  return v;
}

}  // namespace powderlink::analysis
