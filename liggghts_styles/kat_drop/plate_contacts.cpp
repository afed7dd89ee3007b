// SPDX-License-Identifier: GPL-3.0-or-later
#include "liggghts_styles/kat_drop/plate_contacts.h"

#include <algorithm>

#include "liggghts_styles/contact/normal_model_jkr.h"
#include "liggghts_styles/host/stop_all.h"

namespace powderlink::host {

using namespace LAMMPS_NS;

PlateContacts::PlateContacts(LAMMPS* lmp, Fix* asker, const std::string& wall_id) {
  wall_ = dynamic_cast<FixWallGran*>(lmp->modify->find_fix_id(wall_id.c_str()));
  if (wall_ == nullptr || !wall_->contact_match("normal", "jkr")) {
    const std::string message =
        "plate; given: fix '" + wall_id +
        "'; allowed: a fix wall/gran of model jkr "
        "(primitive or mesh) that the script defines before this line; to do: fix " +
        wall_id + " all wall/gran model jkr primitive type 2 zplane 0.0";
    stop_all(lmp, FLERR, asker, message);
  }
  offset_ = wall_->get_history_offset(kRootHistory);
  if (!wall_->is_mesh_wall()) {
    const std::string name = "history_" + wall_id;
    primitive_history_ = static_cast<FixPropertyAtom*>(lmp->modify->find_fix_property(
        name.c_str(), "property/atom", "vector", wall_->dnum(), 0, asker->style));
  }
}

int PlateContacts::plate_type() const {
  return wall_->is_mesh_wall() ? wall_->mesh_list()[0]->atomTypeWall() : wall_->atom_type_wall();
}

double PlateContacts::root(int i) const {
  if (primitive_history_ != nullptr) {
    return primitive_history_->array_atom[i][offset_];
  }
  double root = 0.0;
  for (int m = 0; m < wall_->n_meshes(); ++m) {
    FixContactHistoryMesh* history = wall_->mesh_list()[m]->contactHistory();
    for (int j = 0; j < history->nneighs(i); ++j) {
      if (history->partner(i, j) >= 0)
        root = std::max(root, history->contacthistory(i, j)[offset_]);
    }
  }
  return root;
}

}  // namespace powderlink::host
