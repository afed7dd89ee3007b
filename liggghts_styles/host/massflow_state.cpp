// SPDX-License-Identifier: GPL-3.0-or-later
#include "liggghts_styles/host/massflow_state.h"

#include <cstddef>

#include "liggghts_styles/host/liggghts_headers.h"

#include "fix_massflow_mesh.h"
#include "modify.h"

#include "liggghts_styles/host/owner_mark.h"
#include "liggghts_styles/host/private_access.h"

POWDERLINK_PRIVATE_MEMBER(MassflowNumber, LAMMPS_NS::FixMassflowMesh, nparticles_, double)
POWDERLINK_PRIVATE_MEMBER(MassflowSum, LAMMPS_NS::FixMassflowMesh, property_sum_, double)
POWDERLINK_PRIVATE_MEMBER(MassflowTime, LAMMPS_NS::FixMassflowMesh, t_count_, double)
POWDERLINK_PRIVATE_MEMBER(MassflowInterval, LAMMPS_NS::FixMassflowMesh, delta_t_, double)
POWDERLINK_PRIVATE_MEMBER(MassflowIntervalEnds, LAMMPS_NS::FixMassflowMesh, reset_t_count_, bool)

namespace powderlink::host {

using namespace LAMMPS_NS;

namespace {

constexpr std::size_t kNumbers = 5;

/// Calls visitor(mark, fix) for each.
template <class Visitor>
void visit_all(LAMMPS* lmp, const Visitor& visitor) {
  for (int i = 0; i < lmp->modify->nfix; ++i) {
    auto* massflow = dynamic_cast<FixMassflowMesh*>(lmp->modify->fix[i]);
    if (massflow != nullptr) visitor(mark_of(massflow->id), *massflow);
  }
}

}  // namespace

std::vector<double> massflow_state(LAMMPS* lmp) {
  std::vector<double> state;
  visit_all(lmp, [&](double mark, FixMassflowMesh& fix) {
    state.push_back(mark);
    state.push_back(fix.*pointer_to(MassflowNumber()));
    state.push_back(fix.*pointer_to(MassflowSum()));
    state.push_back(fix.*pointer_to(MassflowTime()));
    state.push_back(fix.*pointer_to(MassflowInterval()));
    state.push_back(fix.*pointer_to(MassflowIntervalEnds()) ? 1.0 : 0.0);
  });
  return state;
}

void set_massflow_state(LAMMPS* lmp, const std::vector<double>& state) {
  visit_all(lmp, [&](double mark, FixMassflowMesh& fix) {
    for (std::size_t at = 0; at + kNumbers < state.size(); at += 1 + kNumbers) {
      if (state[at] != mark) continue;
      fix.*pointer_to(MassflowNumber()) = state[at + 1];
      fix.*pointer_to(MassflowSum()) = state[at + 2];
      fix.*pointer_to(MassflowTime()) = state[at + 3];
      fix.*pointer_to(MassflowInterval()) = state[at + 4];
      fix.*pointer_to(MassflowIntervalEnds()) = state[at + 5] != 0.0;
    }
  });
}

}  // namespace powderlink::host
