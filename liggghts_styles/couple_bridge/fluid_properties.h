// SPDX-License-Identifier: GPL-3.0-or-later
/// \file fluid_properties.h
/// The per-atom values of a coupled run as LIGGGHTS's own fix property/atom: they migrate with their
/// atoms, are in restart files, and dumps and variables read them as f_NAME or f_NAME[1..3].
///
/// Pointers to their arrays are valid until LIGGGHTS moves or adds atoms: ask for them anew each time.
#pragma once

#include <string>
#include <vector>

#include "fix_property_atom.h"
#include "lammps.h"

#include "coupling/bridge/frame/field.h"

namespace powderlink::host {

class FluidProperties {
 public:
  /// Columns of the hidden property `couplingStep`.
  enum Step { kState, kA, kD, kSpinA = kD + 3, kSpinD, kStepColumns = kSpinD + 3 };
  /// Columns of the hidden property `couplingKept`, valid at a checkpoint only: what LIGGGHTS makes
  /// anew at the start of a run. The step of release is that of fix insert/stream.
  enum Kept { kForce, kTorque = kForce + 3, kRelease = kTorque + 3, kKeptColumns };
  /// Columns of the hidden property `couplingPlace`: the particle at the last exchange, or when it
  /// came; the velocity is the last one whose gain the impulse has.
  enum Place { kId, kPosition, kVelocity = kPosition + 3, kPlaceColumns = kVelocity + 3 };
  /// What column kState says; new atoms have kNew. kNothing: outside the mesh of the solver, or new
  /// when the solver knew none.
  enum State { kNew = 0, kOwn = 1, kBorrowed = 2, kNothing = 3 };
  /// Does the fluid act on a particle of that state.
  static bool is_acted_on(double state) { return state == kOwn || state == kBorrowed; }

  explicit FluidProperties(LAMMPS_NS::LAMMPS* lmp) : lmp_(lmp) {}
  /// Makes the properties; to be called in post_create().
  void create(const char* style);
  /// Before the fix goes.
  void remove();
  bool exist() const { return !all_.empty(); }

  /// All fields of a solver that have a property.
  static std::vector<bridge::FieldSpec> known_fields();
  /// The property that takes a field of the solver (coupling_fields.h), or null.
  LAMMPS_NS::FixPropertyAtom* of_field(const std::string& name) const;

  double** fluid_velocity() const { return all_[0]->array_atom; }
  double* fluid_fraction() const { return all_[1]->vector_atom; }
  double* drag_coefficient() const { return all_[2]->vector_atom; }
  double** reacting_force() const { return all_[3]->array_atom; }
  double** pressure_force() const { return all_[4]->array_atom; }
  double** fluid_force() const { return all_[5]->array_atom; }
  double** reaction_impulse() const { return all_[6]->array_atom; }
  double** fluid_spin() const { return all_[7]->array_atom; }
  double* rotational_drag() const { return all_[8]->vector_atom; }
  double** fluid_torque() const { return all_[9]->array_atom; }
  double* added_mass() const { return all_[10]->vector_atom; }
  double** step() const { return all_[11]->array_atom; }
  double** kept() const { return all_[12]->array_atom; }
  double** place() const { return all_[13]->array_atom; }

 private:
  LAMMPS_NS::LAMMPS* lmp_;
  std::vector<LAMMPS_NS::FixPropertyAtom*> all_;
};

}  // namespace powderlink::host
