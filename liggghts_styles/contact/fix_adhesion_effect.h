// SPDX-License-Identifier: GPL-3.0-or-later
/// \file fix_adhesion_effect.h
/// `fix ID group adhesion/effect NAME [p1 p2 ...]`: switches one effect of physics/effects/effects.def on.
///
/// Model `jkr` takes its interface part (roughness, rate dependence), `fix kat/drop` the forces
/// across the gap and the stop of the plate. Parameters in the order that `powderlink effects`
/// prints, all or none (then the typical values). The fix itself computes nothing, and warns at the start of
/// a run in which nothing reads it.
/// Tests: tests/liggghts_styles/kat_drop_test.cpp, tests/liggghts_styles/bad_input_test.cpp
#pragma once

#include <memory>
#include <vector>

#include "fix.h"
#include "physics/effects/effect.h"

namespace powderlink::host {

class FixAdhesionEffect : public LAMMPS_NS::Fix {
 public:
  static constexpr const char* kStyle = "adhesion/effect";

  FixAdhesionEffect(LAMMPS_NS::LAMMPS* lmp, int narg, char** arg);
  int setmask() override { return 0; }
  void setup(int) override;

  /// What asks for the effects: a contact model its interface part, fix kat/drop all of them.
  enum class Reader { contact, drop };
  /// Effects of all fixes of this style, in script order.
  static std::vector<const physics::Effect*> active(LAMMPS_NS::LAMMPS* lmp, Reader reader);

 private:
  std::unique_ptr<physics::Effect> effect_;
  bool read_ = false;  ///< by what uses it
};

}  // namespace powderlink::host
