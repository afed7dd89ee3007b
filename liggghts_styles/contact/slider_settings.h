// SPDX-License-Identifier: GPL-3.0-or-later
/// \file slider_settings.h
/// What tangential model `spring_slider_dashpot` takes from the script beside friction.
/// Tests: tests/liggghts_styles/slider_test.cpp
#pragma once

namespace LAMMPS_NS {
class LAMMPS;
}
class Settings;

namespace powderlink::host {

/// Steps of the slider in a time step: `fix property/global sliderStep scalar DT`; 1 without it.
/// Stops LIGGGHTS when DT is not above 0 or above the time step.
int slider_steps(LAMMPS_NS::LAMMPS* lmp);

/// Keywords of hertz that tangential models share, which this one does not serve.
class SliderSettings {
 public:
  void register_in(Settings& settings);
  /// Stops LIGGGHTS when one of them is on.
  void check(LAMMPS_NS::LAMMPS* lmp) const;

 private:
  bool elastic_ = false, dissipated_ = false;
};

}  // namespace powderlink::host
