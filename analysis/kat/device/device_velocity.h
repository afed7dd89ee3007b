// SPDX-License-Identifier: GPL-3.0-or-later
/// \file device_velocity.h
/// Impact velocity of a drop of the KAT device, with its standard uncertainty.
///
///   w = h/t + g t/2               speed as the carrier of height h leaves the beam, blocked for t
///   v^2 = w^2 + 2 g (L - h)       at the anvil, L below the beam
///   v_f = (L - h)/T + g T/2       the same from the flight time T between beam and anvil
///
/// T ends at the vibration switch less its latency, or at the first contact where there is none.
/// The uncertainties of h, L, the edges and the latency are independent and go into v by the partial
/// derivatives. v and v_f share h, L and one edge; their difference is judged by the larger of both
/// uncertainties added, so that it does not alarm too soon.
/// Source: h/t at the beam, gravity over the rest and the latency of 66 us, L. Pedrolli, doctoral thesis,
/// University of Deusto. Validity: free fall, h <= L. Tests: tests/analysis/kat/kat_device_test.cpp
#pragma once

#include <optional>
#include <string>

#include "kat_firmware/core/kat_drop.h"

namespace powderlink::analysis {

struct DeviceSigmas {
  double carrier_um = 50.0;  ///< of h
  double beam_um = 500.0;    ///< of L
  double edge_us = 1.0;      ///< of every edge of the beam: clock and interrupt
  double latency_us = 10.0;  ///< of the vibration switch
};

struct DeviceVelocity {
  double value_m_s = 0.0, sigma_m_s = 0.0;
  std::optional<double> flight_m_s{}, flight_sigma_m_s{};  ///< from T; absent when L = h
  /// False: beam and flight differ by more than three times their uncertainty.
  bool consistent = true;
};

/// Throws InvalidInput for times or a geometry that are no free fall; `where` names the drop.
DeviceVelocity device_velocity(const kat::Drop& drop, const DeviceSigmas& sigmas,
                               const std::string& where);

}  // namespace powderlink::analysis
