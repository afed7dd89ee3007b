// SPDX-License-Identifier: GPL-3.0-or-later
#include "liggghts_styles/couple_bridge/coupled_world.h"

#include "coupling/bridge/link/coupling_link.h"

namespace powderlink::host {

namespace {

bridge::MpiWorld& world_of_process() {
  static bridge::MpiWorld world;
  return world;
}

bool parted = false;

}  // namespace

const bridge::MpiWorld& coupled_world() { return world_of_process(); }
void set_coupled_world(const bridge::MpiWorld& world) { world_of_process() = world; }

bool has_parted() { return parted; }
void note_parted() { parted = true; }

void say_last_words(const std::string& why) { bridge::say_last_words(why); }

}  // namespace powderlink::host
