// SPDX-License-Identifier: GPL-3.0-or-later
#include "liggghts_styles/couple_bridge/fluid_properties.h"

#include "modify.h"

#include "coupling/bridge/exchange/coupling_fields.h"

namespace powderlink::host {

namespace {

namespace fields = bridge::fields;

struct Property {
  const char* name;
  int components;
  const char* initial;
  const bridge::FieldSpec* field;  ///< of the solver; null: made here
};
/// In the order of FluidProperties.
const Property kProperties[] = {{"fluidVelocity", 3, "0.", &fields::fluid_velocity},
                                {"fluidFraction", 1, "1.", &fields::fluid_fraction},
                                {"dragCoefficient", 1, "0.", &fields::drag_coefficient},
                                {"reactingForce", 3, "0.", &fields::reacting_force},
                                {"pressureForce", 3, "0.", &fields::pressure_force},
                                {"fluidForce", 3, "0.", nullptr},
                                {"reactionImpulse", 3, "0.", nullptr},
                                {"fluidSpin", 3, "0.", &fields::fluid_spin},
                                {"rotationalDrag", 1, "0.", &fields::rotational_drag},
                                {"fluidTorque", 3, "0.", &fields::fluid_torque},
                                {"addedMass", 1, "0.", &fields::added_mass},
                                {"couplingStep", FluidProperties::kStepColumns, "0.", nullptr},
                                {"couplingKept", FluidProperties::kKeptColumns, "0.", nullptr},
                                {"couplingPlace", FluidProperties::kPlaceColumns, "0.", nullptr}};

}  // namespace

std::vector<bridge::FieldSpec> FluidProperties::known_fields() {
  std::vector<bridge::FieldSpec> known;
  for (const Property& property : kProperties) {
    if (property.field != nullptr) known.push_back(*property.field);
  }
  return known;
}

LAMMPS_NS::FixPropertyAtom* FluidProperties::of_field(const std::string& name) const {
  for (std::size_t i = 0; i < all_.size(); ++i) {
    const bridge::FieldSpec* field = kProperties[i].field;
    if (field != nullptr && field->name == name) return all_[i];
  }
  return nullptr;
}

void FluidProperties::create(const char* style) {
  for (const Property& property : kProperties) {
    std::vector<std::string> words = {property.name,
                                      "all",
                                      "property/atom",
                                      property.name,
                                      property.components == 1 ? "scalar" : "vector",
                                      "yes",  // in restart files
                                      "no",   // not on ghosts
                                      "no"};
    for (int c = 0; c < property.components; ++c) words.emplace_back(property.initial);
    std::vector<char*> arguments;
    arguments.reserve(words.size());
    for (std::string& word : words) arguments.push_back(word.data());
    all_.push_back(lmp_->modify->add_fix_property_atom(static_cast<int>(arguments.size()),
                                                       arguments.data(), style));
  }
}

void FluidProperties::remove() {
  if (!exist()) return;
  for (const Property& property : kProperties) lmp_->modify->delete_fix(property.name);
  all_.clear();
}

}  // namespace powderlink::host
