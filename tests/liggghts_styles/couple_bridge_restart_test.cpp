// SPDX-License-Identifier: GPL-3.0-or-later
// A coupled run that goes on from a checkpoint is the run that did not stop: grains in contact with each
// other and with walls, insertion, one and two ranks. Nothing in it is random or depends on timing, so
// both must agree in all digits of the dump.
#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "couple_bridge_case.h"

namespace powderlink::testing {
namespace {

constexpr int kCheckpoint = 120;  ///< step of exchange 12
constexpr int kEnd = 320;
/// The gas presses the grains on the plate with five hundred times their weight.
constexpr const char* kBedGas =
    "box=-1e-3,1e-3 wind=3,0,0 stokes=2e-5 press=0,0,-2e-5 added_mass=0.2 turn=50,1e-15,0";

struct Contacts {
  const char* name;
  const char* model;
  const char* options;
  bool mesh;
  int ranks;
  const char* more = "";  ///< lines of the script
};

void PrintTo(const Contacts& c, std::ostream* out) { *out << c.name; }

constexpr const char* kData = "read_data";  ///< begins the line that a restart replaces

/// Two layers that are pressed into each other and into a plate while they slide over it.
std::string bed(const LiggghtsCase& c, const Contacts& contacts) {
  std::vector<Sphere> spheres;
  for (int i = 0; i < 72; ++i) {
    const int layer = i / 36;
    Sphere s = grain(-5.2e-4 + 0.97e-4 * (i % 12) + 0.3e-4 * layer,
                     -1.1e-4 + 0.97e-4 * (i / 12 % 3) + 0.2e-4 * layer, 0.485e-4 + 0.91e-4 * layer);
    s.diameter = 96e-6 + 0.1e-6 * (i * 7 % 37);
    for (int k = 0; k < 3; ++k) s.v[k] = 0.2 * std::sin(1.0 + i * (k + 1)) - (k == 2 ? 0.1 : 0.0);
    s.v[0] += 0.3;
    s.omega[1] = 800.0 * std::sin(2.0 * i);
    spheres.push_back(s);
  }
  c.write_spheres("spheres.data", spheres, 1e-3);
  c.write_plate("plate.stl", 0.95e-3, 3);
  Setting s = soft_spheres(contacts.model);
  s.youngs_modulus[0] = s.youngs_modulus[1] = 6e6;
  s.model_options = contacts.options;
  std::string script = header(s, "spheres.data");
  script.replace(script.find("boundary m m m"), 14, "boundary p p f");
  script.insert(script.find("pair_style"),
                "fix speed all property/global characteristicVelocity scalar 2.0\n");
  if (contacts.ranks == 2) script = "processors 2 1 1\n" + script;
  script += contacts.mesh ? mesh_plate(s) : primitive_plate(s);
  script += contacts.more;
  return script + "fix weight all gravity 9.81 vector 0 0 -1\n" + kGas + dump_lines(10) +
         "dump more all custom 10 more.dump id omegax omegay\n"
         "dump_modify more sort id format \"%d %.17g %.17g\"\n";
}

/// With the plate and with each other.
int overlaps(const Snapshot& grains) {
  int count = 0;
  for (const auto& [id, a] : grains) {
    if (a[kZ] < a[kRadius]) ++count;
    for (const auto& [other, b] : grains) {
      if (other <= id) continue;
      double distance2 = 0.0;
      for (int k = kX; k <= kZ; ++k) distance2 += (a[k] - b[k]) * (a[k] - b[k]);
      if (std::sqrt(distance2) < a[kRadius] + b[kRadius]) ++count;
    }
  }
  return count;
}

/// Runs the script as a whole and again from its checkpoint; the columns that must agree.
void expect_continuation(const LiggghtsCase& c, std::string script, const std::string& gas,
                         int ranks, const std::vector<const char*>& dumps,
                         const char* counts = nullptr, int stop = kEnd) {
  Outcome o = c.couple(script + "run " + std::to_string(kEnd) + "\n",
                       {interval() + gas + " checkpoint=12", ranks, 1});
  ASSERT_EQ(o.status, 0) << o.output;
  std::vector<std::map<long, Snapshot>> whole;
  for (const char* dump : dumps) whole.push_back(read_dump(c.folder() / dump));
  const auto counted = counts ? read_log(c.folder() / counts) : read_log("");
  if (stop != kEnd) {
    std::filesystem::remove_all(c.folder() / "post");
    o = c.couple(script + "run " + std::to_string(stop) + "\n",
                 {interval() + gas + " checkpoint=12", ranks, 1});
    ASSERT_EQ(o.status, 0) << o.output;
  }
  const auto at = script.find(kData);
  script.replace(at, script.find('\n', at) - at, "read_restart post/restart.120");
  o = c.couple(script + "run " + std::to_string(kEnd) + " upto\n",
               {interval() + gas + " time=1.2e-4 ahead=0 log=again.txt", ranks, 1});
  ASSERT_EQ(o.status, 0) << o.output;
  EXPECT_EQ(read_log(c.folder() / "again.txt").front()[0], kCheckpoint);
  for (std::size_t i = 0; i < dumps.size(); ++i) {
    auto again = read_dump(c.folder() / dumps[i]);
    for (int step = kCheckpoint + 10; step <= kEnd; step += 10) {
      ASSERT_GT(whole[i][step].size(), 0u);
      ASSERT_EQ(whole[i][step], again[step]) << dumps[i] << ", step " << step;
    }
  }
  if (!counts) return;
  const auto after = read_log(c.folder() / counts);
  ASSERT_EQ(after.size(), std::size_t{(kEnd - kCheckpoint) / 10});
  for (std::size_t i = 1; i <= after.size(); ++i) {
    EXPECT_EQ(after[after.size() - i], counted[counted.size() - i]);
  }
}

class CoupleBridgeContacts : public ::testing::TestWithParam<Contacts> {};

TEST_P(CoupleBridgeContacts, GoOnExactly) {
  const Contacts& contacts = GetParam();
  const LiggghtsCase c(std::string("couple_contacts_") + contacts.name);
  expect_continuation(c, bed(c, contacts), kBedGas, contacts.ranks, {"all.dump", "more.dump"});
  const auto dump = read_dump(c.folder() / "all.dump");
  const Snapshot& after = dump.at(kCheckpoint + 10);
  EXPECT_GT(overlaps(after), 50) << "hardly a contact: little was tested";
}

constexpr const char* kMotion = "fix motion all move/mesh mesh cad linear 0.2 -0.1 0.\n";

const Contacts kContacts[] = {
    {"hertz_primitive_1", "hertz", " tangential history", false, 1},
    {"hertz_primitive_2", "hertz", " tangential history", false, 2},
    {"hertz_mesh_1", "hertz", " tangential history", true, 1},
    {"hertz_mesh_2", "hertz", " tangential history", true, 2},
    {"hertz_epsd2_mesh_2", "hertz", " tangential history rolling_friction epsd2", true, 2},
    {"hooke_primitive_1", "hooke", " tangential history", false, 1},
    {"jkr_primitive_1", "jkr", " tangential history", false, 1},
    {"jkr_primitive_2", "jkr", " tangential history rolling_friction cdt", false, 2},
    {"hertz_moving_mesh_1", "hertz", " tangential history", true, 1, kMotion},
    {"hertz_moving_mesh_2", "hertz", " tangential history", true, 2, kMotion},
    {"jkr_mesh_1", "jkr", " tangential history", true, 1},
    {"jkr_mesh_2", "jkr", " tangential history rolling_friction epsd2", true, 2},
};

INSTANTIATE_TEST_SUITE_P(Cases, CoupleBridgeContacts, ::testing::ValuesIn(kContacts),
                         [](const auto& info) { return std::string(info.param.name); });

/// A restart file knows of the coupled run that it comes from.
TEST(CoupleBridgeMoments, ParticlesOfAnotherMomentThanTheFluidAreRefused) {
  const LiggghtsCase c("couple_moments");
  c.write_spheres("spheres.data", {grain(-1e-3), grain(1e-3)}, 1e-2);
  std::string script = header(soft_spheres(), "spheres.data") + kGas;
  const std::string gas = interval() + "wind=1,0,0 drag=1e-6 ";
  // Two jobs: in one mpirun the program that is first to stop may end the other before it has spoken.
  script.replace(script.find("every 10"), 8, "every 10 transport socket rendezvous meet");
  // The particles are 1e-4 s old when the fluid begins.
  script.insert(script.find("fix integrate"), "reset_timestep 100\n");
  Outcome o = c.couple(script + "run 100\n", {gas + "checkpoint=5", 1, 1, true});
  ASSERT_EQ(o.status, 0) << o.output;
  script.replace(script.find("reset_timestep 100\n"), 19, "");
  script.replace(script.find("read_data spheres.data"), 22, "read_restart post/restart.150");
  for (const char* fluid : {"time=5e-5 ahead=-1e-4", "time=5e-5"}) {
    o = c.couple(script + "run 20\n", {gas + fluid, 1, 1, true});
    EXPECT_EQ(o.status, 0) << o.output;
  }
  for (const char* fluid : {"time=6e-5 ahead=-1e-4", "time=6e-5", "time=0"}) {
    o = c.couple(script + "run 20\n", {gas + fluid, 2, 1, true});
    EXPECT_NE(o.status, 0) << fluid;
    EXPECT_LT(o.status, 124) << o.output;
    for (const char* words :
         {"Fix couple/bridge (id gas): coupling states at the start; given: ",
          "fake solver: coupling states at the start; given: ", "; allowed: ", "; to do: "}) {
      EXPECT_NE(o.output.find(words), std::string::npos) << words << "\n" << o.output;
    }
  }
  // Under another name the fix begins a new run with these particles.
  script.replace(script.find("fix gas"), 7, "fix air");
  o = c.couple(script + "run 20\n", {gas + "time=0", 1, 1, true});
  EXPECT_EQ(o.status, 0) << o.output;
}

/// The script ends at the moment of a checkpoint, before the exchange of that step.
TEST(CoupleBridgeContactsAtTheEnd, TheCheckpointOfTheLastStepIsMade) {
  for (const Contacts& contacts : {kContacts[0], kContacts[3]}) {
    const LiggghtsCase c(std::string("couple_end_") + contacts.name);
    expect_continuation(c, bed(c, contacts), kBedGas, contacts.ranks, {"all.dump", "more.dump"},
                        nullptr, kCheckpoint);
  }
}

/// Grains that come through a face and in a region, with random places, sizes and speeds, and go.
TEST(CoupleBridgeInsertion, TheSameGrainsCome) {
  for (const int ranks : {1, 2}) {
    const LiggghtsCase c("couple_inflow_" + std::to_string(ranks));
    c.write_spheres("spheres.data", {grain(5e-4, 0.0, -5e-4)}, 1e-3);
    c.write_plate("face.stl", 3e-4, 1);
    c.write_plate("plate.stl", 9e-4, 2);
    std::string script = header(soft_spheres(), "spheres.data");
    script.replace(script.find("boundary m m m"), 14, "boundary f f f");
    if (ranks == 2) script = "processors 2 1 1\n" + script;
    script +=
        "region pack block -8e-4 8e-4 -8e-4 8e-4 2e-4 4e-4 units box volume_limit 1e-16\n"
        "fix small all particletemplate/sphere 86028157 atom_type 1 density constant 8000 radius "
        "constant 28e-6 volume_limit 1e-20\n"
        "fix large all particletemplate/sphere 49979687 atom_type 1 density constant 8000 radius "
        "constant 40e-6 volume_limit 1e-20\n"
        "fix sizes all particledistribution/discrete 67867967 2 small 0.5 large 0.5\n"
        "fix face all mesh/surface/planar file face.stl type 2 precision 1e-12 move 0 0 6e-4\n"
        "fix stream all insert/stream seed 32452867 distributiontemplate sizes nparticles INF "
        "particlerate 2e5 insert_every 37 overlapcheck yes maxattempt 1000 vel gaussian 0. 0. -4. "
        "0.3 0.3 0.1 insertion_face face\n"
        "fix rain all insert/pack seed 15485867 distributiontemplate sizes insert_every 34 "
        "overlapcheck yes all_in yes vel uniform 1. 0. -3. 0.5 0.5 0.5 region pack "
        "particles_in_region 9 ntry_mc 1000\n"
        "fix drain_mesh all mesh/surface file plate.stl type 2 precision 1e-12\n"
        "fix shares all property/atom share scalar yes no no 2.\n"
        "fix drain all massflow/mesh mesh drain_mesh vec_side 0. 0. -1. sum_property share count "
        "once "
        "delete_atoms yes\nthermo_style custom step f_drain[2] f_drain[3]\nthermo 10\n"
        "thermo_modify lost ignore\n";
    script += kGas + dump_lines(10) +
              "variable at equal step\nvariable came equal f_stream[1]+f_rain[1]\n"
              "variable mass equal f_stream[2]+f_rain[2]\nvariable went equal f_drain[6]\n"
              "variable lost equal f_drain[5]\nvariable passed equal f_drain[2]\n"
              "variable rate equal f_drain[3]\nvariable number_rate equal f_drain[4]\n"
              "variable sum equal f_drain[7]\n"
              "fix counts all print 10 \"${at} ${came} ${mass} ${went} ${lost} ${passed} ${rate} "
              "${number_rate} ${sum}\" file counts.txt "
              "screen no title none\n";
    expect_continuation(c, script, "box=-1e-3,1e-3 wind=1,0,0 stokes=2e-5", ranks, {"all.dump"},
                        "counts.txt");
    const auto dump = read_dump(c.folder() / "all.dump");
    const auto& last = dump.at(kEnd);
    long highest = 0;
    for (const auto& [id, row] : last) highest = std::max(highest, id);
    EXPECT_GT(highest, 60) << "hardly a grain came";
    EXPECT_LT(last.size(), static_cast<std::size_t>(highest)) << "none has left";
  }
}

}  // namespace
}  // namespace powderlink::testing
