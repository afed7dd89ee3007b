// SPDX-License-Identifier: GPL-3.0-or-later
/// \file universal_tables.h
/// The two functions g and h of critical_speed.h, tabulated from the reduced model of one sphere.
/// Nodes are computed when they are first asked for and kept; safe for several threads.
/// Tests: tests/analysis/kat/critical_speed_test.cpp
#pragma once

#include "physics/kat/stop_pulse.h"

namespace powderlink::analysis {

/// v_c/v_esc of a stop that lasts the given number of contact periods; half-sine or Hertz.
double slowness_factor(physics::StopPulse::Shape shape, double periods);

/// v_c/v_esc of an instant stop with Gamma (1 + (v/v*)^n); reduced_speed is v* T/a0.
double moving_edge_factor(double reduced_speed, double exponent);

}  // namespace powderlink::analysis
