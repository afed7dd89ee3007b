// SPDX-License-Identifier: GPL-3.0-or-later
#include "host/coupled_world.h"

namespace powderlink::host {

namespace {

bridge::MpiWorld& world_of_process() {
  static bridge::MpiWorld world;
  return world;
}

}  // namespace

const bridge::MpiWorld& coupled_world() { return world_of_process(); }
void set_coupled_world(const bridge::MpiWorld& world) { world_of_process() = world; }

}  // namespace powderlink::host
