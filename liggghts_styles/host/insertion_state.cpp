// SPDX-License-Identifier: GPL-3.0-or-later
#include "liggghts_styles/host/insertion_state.h"

#include <iterator>
#include <map>
#include <type_traits>

#include "liggghts_styles/host/liggghts_headers.h"

#include "domain.h"
#include "fix_insert_pack.h"
#include "fix_particledistribution_discrete.h"
#include "fix_template_sphere.h"
#include "random_park.h"
#include "region.h"

#include "liggghts_styles/host/owner_mark.h"
#include "liggghts_styles/host/private_access.h"

POWDERLINK_PRIVATE_MEMBER(Seed, LAMMPS_NS::Random, seed, int)
POWDERLINK_PRIVATE_MEMBER(HasSecond, LAMMPS_NS::RanPark, save, int)
POWDERLINK_PRIVATE_MEMBER(Second, LAMMPS_NS::RanPark, second, double)
POWDERLINK_PRIVATE_MEMBER(OfInsertion, LAMMPS_NS::FixInsert, random, LAMMPS_NS::RanPark*)
POWDERLINK_PRIVATE_MEMBER(StreamShare, LAMMPS_NS::FixInsertStream, ins_fraction, double)
POWDERLINK_PRIVATE_MEMBER(StreamShareIsDue, LAMMPS_NS::FixInsertStream, do_ins_fraction_calc, bool)
POWDERLINK_PRIVATE_MEMBER(StreamNear, LAMMPS_NS::FixInsertStream, extrude_length_min, double)
POWDERLINK_PRIVATE_MEMBER(StreamFar, LAMMPS_NS::FixInsertStream, extrude_length_max, double)
POWDERLINK_PRIVATE_MEMBER(PackVolume, LAMMPS_NS::FixInsertPack, region_volume, double)
POWDERLINK_PRIVATE_MEMBER(PackLocalVolume, LAMMPS_NS::FixInsertPack, region_volume_local, double)
POWDERLINK_PRIVATE_MEMBER(OfDistribution, LAMMPS_NS::FixParticledistributionDiscrete, random,
                          LAMMPS_NS::RanPark*)
POWDERLINK_PRIVATE_MEMBER(OfTemplate, LAMMPS_NS::FixTemplateSphere, random_insertion,
                          LAMMPS_NS::RanPark*)
POWDERLINK_PRIVATE_MEMBER(OfTemplateVolume, LAMMPS_NS::FixTemplateSphere, random_mc,
                          LAMMPS_NS::RanPark*)
POWDERLINK_PRIVATE_MEMBER(OfMesh, LAMMPS_NS::MultiNodeMesh<3>, random_, LAMMPS_NS::RanPark*)
POWDERLINK_PRIVATE_MEMBER(OfRegion, LAMMPS_NS::Region, random, LAMMPS_NS::RanPark*)

namespace powderlink::host {

using namespace LAMMPS_NS;

namespace {

template <class Visitor>
void visit(RanPark* random, Visitor& visitor) {
  if (random == nullptr) return;
  visitor(random->*pointer_to(Seed()));
  visitor(random->*pointer_to(HasSecond()));
  visitor(random->*pointer_to(Second()));
}

/// Calls begin(name) for each fix and region, then visitor(number) for each number of its state.
template <class Begin, class Visitor>
void visit_all(LAMMPS* lmp, const Begin& begin, Visitor& visitor) {
  for (int i = 0; i < lmp->modify->nfix; ++i) {
    Fix* fix = lmp->modify->fix[i];
    begin(std::string("fix ") + fix->id);
    if (auto* insertion = dynamic_cast<FixInsert*>(fix)) {
      visit(insertion->*pointer_to(OfInsertion()), visitor);
    }
    if (auto* stream = dynamic_cast<FixInsertStream*>(fix)) {
      visitor(stream->*pointer_to(StreamShare()));
      visitor(stream->*pointer_to(StreamShareIsDue()));
      visitor(stream->*pointer_to(StreamNear()));
      visitor(stream->*pointer_to(StreamFar()));
    }
    if (auto* pack = dynamic_cast<FixInsertPack*>(fix)) {
      visitor(pack->*pointer_to(PackVolume()));
      visitor(pack->*pointer_to(PackLocalVolume()));
    }
    if (auto* distribution = dynamic_cast<FixParticledistributionDiscrete*>(fix)) {
      visit(distribution->*pointer_to(OfDistribution()), visitor);
    }
    if (auto* particle = dynamic_cast<FixTemplateSphere*>(fix)) {
      visit(particle->*pointer_to(OfTemplate()), visitor);
      visit(particle->*pointer_to(OfTemplateVolume()), visitor);
    }
    if (auto* mesh = dynamic_cast<FixMeshSurface*>(fix)) {
      visit(mesh->triMesh()->*pointer_to(OfMesh()), visitor);
    }
  }
  for (int i = 0; i < lmp->domain->nregion; ++i) {
    Region* region = lmp->domain->regions[i];
    begin(std::string("region ") + region->id);
    visit(region->*pointer_to(OfRegion()), visitor);
  }
}

using Numbers = std::vector<double>;

/// The state by owner; those without one are left out.
std::map<std::string, Numbers> states_of(LAMMPS* lmp) {
  std::map<std::string, Numbers> states;
  Numbers* of_owner = nullptr;
  const auto read = [&](const auto& number) { of_owner->push_back(static_cast<double>(number)); };
  visit_all(
      lmp, [&](const std::string& owner) { of_owner = &states[owner]; }, read);
  for (auto at = states.begin(); at != states.end();) {
    at = at->second.empty() ? states.erase(at) : std::next(at);
  }
  return states;
}

}  // namespace

std::vector<double> insertion_state(LAMMPS* lmp) {
  Numbers all;
  for (const auto& [owner, numbers] : states_of(lmp)) {
    all.push_back(mark_of(owner));
    all.push_back(static_cast<double>(numbers.size()));
    all.insert(all.end(), numbers.begin(), numbers.end());
  }
  return all;
}

std::string set_insertion_state(LAMMPS* lmp, const std::vector<double>& state) {
  std::map<double, Numbers> kept;
  for (std::size_t at = 0; at + 1 < state.size();) {
    const auto first = state.begin() + static_cast<std::ptrdiff_t>(at) + 2;
    const auto count = static_cast<std::ptrdiff_t>(state[at + 1]);
    kept[state[at]] = Numbers(first, first + count);
    at += 2 + static_cast<std::size_t>(count);
  }
  std::string unknown;
  std::map<std::string, Numbers> next = states_of(lmp);
  for (auto& [owner, numbers] : next) {
    const auto found = kept.find(mark_of(owner));
    if (found != kept.end() && found->second.size() == numbers.size()) {
      numbers = found->second;
    } else {
      unknown += (unknown.empty() ? "" : ", ") + owner;
    }
  }
  const double* number_of_owner = nullptr;
  const auto write = [&](auto& number) {
    number = static_cast<std::decay_t<decltype(number)>>(*number_of_owner++);
  };
  visit_all(
      lmp, [&](const std::string& owner) { number_of_owner = next[owner].data(); }, write);
  return unknown;
}

}  // namespace powderlink::host
