// SPDX-License-Identifier: GPL-3.0-or-later
/// \file counting_floor.h
/// Irregularity that a stream of single grains has by chance, and how well a measured one is known.
///
///   floor = sqrt((1 + c^2)/(r w)) sqrt(1 - tau/(3 w))      for tau <= w, else with w and tau exchanged
///   r    grains per time [1/s], arriving independently of each other
///   c    standard deviation of a grain's mass over its mean
///   w    window of the average [s]
///   tau  time in which a grain crosses the slice in which the flow is taken, dz/v [s]; 0 for a plane
/// The flow through a slice of uniform speed is the one through a plane, averaged over tau: the kernel
/// of both averages is a trapezoid of area 1, whose squared integral is (1 - tau/(3 w))/w.
///
/// The interval is that of a standard deviation of K = T/w independent windows: K - 1 degrees of
/// freedom, chi-square, equal tails; its relative standard error is 1/sqrt(2 K).
/// Tests: tests/analysis/flow/flow_observables_test.cpp
#pragma once

#include <optional>

#include "analysis/flow/run/flow_statistics.h"

namespace powderlink::analysis {

/// As a fraction of the mean. Rate and window above 0.
double counting_floor(double rate_1_s, double window_s, double mass_variation, double transit_s);

/// 95 % interval of an rms over a record of length T; empty with fewer than three windows.
std::optional<Interval> rms_interval(double rms, double record_s, double window_s);

}  // namespace powderlink::analysis
