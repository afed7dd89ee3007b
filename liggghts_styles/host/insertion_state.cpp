// SPDX-License-Identifier: GPL-3.0-or-later
#include "host/insertion_state.h"

#include "host/liggghts_headers.h"

#include "domain.h"
#include "fix_insert_pack.h"
#include "fix_particledistribution_discrete.h"
#include "fix_template_sphere.h"
#include "random_park.h"
#include "region.h"

#include "host/private_access.h"

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

/// Calls visitor(number) for each number of the state.
template <class Visitor>
void visit_all(LAMMPS* lmp, Visitor& visitor) {
  for (int i = 0; i < lmp->modify->nfix; ++i) {
    Fix* fix = lmp->modify->fix[i];
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
    visit(lmp->domain->regions[i]->*pointer_to(OfRegion()), visitor);
  }
}

struct Reader {
  std::vector<double> state;
  template <class Number>
  void operator()(const Number& number) {
    state.push_back(static_cast<double>(number));
  }
};

struct Writer {
  const double* next;
  template <class Number>
  void operator()(Number& number) {
    number = static_cast<Number>(*next++);
  }
};

}  // namespace

std::vector<double> insertion_state(LAMMPS* lmp) {
  Reader reader;
  visit_all(lmp, reader);
  return reader.state;
}

bool set_insertion_state(LAMMPS* lmp, const std::vector<double>& state) {
  if (insertion_state(lmp).size() != state.size()) return false;
  Writer writer{state.data()};
  visit_all(lmp, writer);
  return true;
}

}  // namespace powderlink::host
