// SPDX-License-Identifier: GPL-3.0-or-later
/// \file fluid_loan.h
/// What a particle that is new between two exchanges takes over from one that the solver knows.
///
/// Fluid velocity, spin and fraction as they are; drag in proportion to the radius (Stokes), rotational
/// drag, pressure force and added mass to the volume; no other force. Stored per m, per m^3.
/// Tests: tests/liggghts_styles/couple_bridge_test.cpp
#pragma once

#include <array>

#include "liggghts_styles/couple_bridge/fluid_properties.h"

namespace powderlink::host {

class FluidLoan {
 public:
  FluidLoan() = default;
  FluidLoan(const FluidProperties& from, int i, double radius) {
    const double volume = radius * radius * radius;
    for (int c = 0; c < 3; ++c) {
      values_[c] = from.fluid_velocity()[i][c];
      values_[3 + c] = from.fluid_spin()[i][c];
      values_[6 + c] = from.pressure_force()[i][c] / volume;
    }
    values_[9] = from.fluid_fraction()[i];
    values_[10] = from.drag_coefficient()[i] / radius;
    values_[11] = from.rotational_drag()[i] / volume;
    values_[12] = from.added_mass()[i] / volume;
  }

  void give(const FluidProperties& to, int i, double radius) const {
    const double volume = radius * radius * radius;
    for (int c = 0; c < 3; ++c) {
      to.fluid_velocity()[i][c] = values_[c];
      to.fluid_spin()[i][c] = values_[3 + c];
      to.pressure_force()[i][c] = values_[6 + c] * volume;
    }
    to.fluid_fraction()[i] = values_[9];
    to.drag_coefficient()[i] = values_[10] * radius;
    to.rotational_drag()[i] = values_[11] * volume;
    to.added_mass()[i] = values_[12] * volume;
  }

  void add(const FluidLoan& other) {
    for (std::size_t k = 0; k < values_.size(); ++k) values_[k] += other.values_[k];
  }
  void divide(double by) {
    for (double& value : values_) value /= by;
  }

  double* data() { return values_.data(); }
  static constexpr int size() { return 13; }

 private:
  std::array<double, 13> values_{};
};

}  // namespace powderlink::host
