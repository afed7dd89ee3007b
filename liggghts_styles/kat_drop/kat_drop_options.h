// SPDX-License-Identifier: GPL-3.0-or-later
/// \file kat_drop_options.h
/// The arguments of `fix kat/drop`, parsed and checked.
///
///   fix ID group kat/drop wall WALL-ID plate xplane|yplane|zplane COORDINATE velocity V
///       [fall -x|+x|-y|+y|-z|+z]     default -z: grains hang below the plate and leave downwards
///       [stop instant | halfsine TAU | hertz TAU | file FILE]    default instant
///       [rebound E_P]                of the plate, default 0
///       [frame plate|moving]         default plate; moving needs a mesh wall
///       [gravity G]                  along the fall, default 9.81 m/s^2
///       [settle TIME] [watch TIME]   limits; defaults are 200 and 6 contact periods
///       [populate type T density RHO sizes range DMIN DMAX N
///                                        | list N D1 ... DN
///                                        | rosinrammler X0 EXPONENT DMIN DMAX N SEED]
///       [results FILE]               JSON, written when the test is over
/// SI units. FILE of the stop: two columns, time [s] and deceleration [m/s^2], '#' comments.
/// Tests: tests/liggghts_styles/kat_drop/kat_drop_options_test.cpp
#pragma once

#include <string>
#include <vector>

#include "physics/kat/stop_pulse.h"

namespace powderlink::host {

struct KatDropOptions {
  std::string wall_id;
  int axis = 2;               ///< 0, 1, 2: normal of the plate
  double plate_position = 0;  ///< along the axis [m]
  double direction = -1.0;    ///< of the fall along the axis, +1 or -1
  double velocity_m_s = 0.0;
  bool stop_given = false;
  physics::StopPulse stop;
  bool moving_frame = false;
  double gravity_m_s2 = 9.81;
  double settle_limit_s = 0.0;  ///< 0: default
  double watch_s = 0.0;         ///< 0: default
  std::string results_file;

  int populate_type = 0;  ///< 0: the script creates the grains
  double density_kg_m3 = 0.0;
  std::vector<double> diameters_m;

  /// Throws InvalidInput.
  static KatDropOptions parse(int narg, const char* const* arg);
};

}  // namespace powderlink::host
