// SPDX-License-Identifier: GPL-3.0-or-later
// What takes MPI_COMM_WORLD in the particles' program - VTK's dumps, the timing of LIGGGHTS - in one mpirun
// with another program: it must see LIGGGHTS's ranks only.
#include <fstream>
#include <set>

#include <gtest/gtest.h>

#include "couple_bridge_case.h"

namespace powderlink::testing {
namespace {

/// Every dump style of the LIGGGHTS package; `movie` asks for a program that is none of its own.
constexpr const char* kDumps = R"(
dump atom all atom/vtk 20 post/atom_*.vtk
dump custom all custom 20 post/custom_*.dump id type x y z
dump vtk all custom/vtk 20 post/particles_*.vtk id type x y z radius
dump vtp all custom/vtk 20 post/particles_*.vtp id type x y z radius
dump vtu all custom/vtk 20 post/particles_*.vtu id type x y z radius
dump vtm all custom/vtm 20 post/all_*.vtm particle_properties id type x y z radius meshes all &
  mesh_properties id stress local_gran pairs write_pvd_file yes
dump boxes all decomposition/vtk 20 post/boxes_*.vtk
dump euler all euler/vtk 20 post/euler_*.vtk
dump image all image 20 post/image_*.ppm type type size 64 64
dump local all local 20 post/local_*.txt c_pairs[1] c_pairs[2]
dump pairs all local/gran/vtk 20 post/pairs_*.vtk pairs
dump pairs_vtp all local/gran/vtk 20 post/pairs_*.vtp pairs
dump mesh_stl all mesh/stl 20 post/mesh_*.stl
dump stl all stl 20 post/stl_*.stl
dump mesh_vtk all mesh/vtk 20 post/mesh_*.vtk stress id cad
dump mesh_vtp all mesh/vtk 20 post/mesh_*.vtp stress id cad
dump mesh_gran all mesh/gran/VTK 20 post/mesh_gran_*.vtk stress id cad
dump mesh_vtm all mesh/vtm 20 post/meshes_*.vtm meshes all mesh_properties id stress
dump xyz all xyz 20 post/xyz_*.xyz
)";

std::string dumping_script(const LiggghtsCase& c, const std::string& bridge) {
  Setting s = soft_spheres();
  s.skin = 5e-4;  // few bins in a box that is large against the grains
  std::vector<Sphere> grains;
  for (int i = 0; i < 4; ++i) {
    for (const double beside : {0.0, 0.98 * kDiameter}) {  // pairs in contact, on the plate
      grains.push_back(grain(-3e-3 + 2e-3 * i + beside, 0.0, 0.49 * kDiameter));
    }
  }
  c.write_spheres("spheres.data", grains, 1e-2);
  c.write_plate("plate.stl", 5e-3, 2);
  std::filesystem::create_directories(c.folder() / "post");
  std::string plate = mesh_plate(s);
  plate.replace(plate.find("mesh/surface "), 13, "mesh/surface/stress ");
  return header(s, "spheres.data") + plate +
         "fix integrate all nve/sphere\n"
         "fix euler all ave/euler nevery 10 cell_size_relative 50 parallel no\n"
         "compute pairs all pair/gran/local pos vel id force\n"
         "compute energy all ke\n"
         "fix mean all ave/time 10 2 20 c_energy file post/mean.txt\n"
         "fix gas all couple/bridge every 10" +
         bridge + "\nmodify_timing verbose\nrestart 20 post/own.*\n" + kDumps +
         "run 20\nwrite_restart post/at_the_end\nwrite_data post/data.txt\n"
         "write_dump all custom post/written.txt id x\n";
}

/// Of a file in post, without the addresses by which VTK names arrays that have no name.
std::string text_of(const LiggghtsCase& c, const std::string& file) {
  std::ifstream in(c.folder() / "post" / file);
  std::stringstream read;
  read << in.rdbuf();
  std::string text = read.str();
  const std::string name = "Name=\"Array 0x";
  for (auto at = text.find(name); at != std::string::npos; at = text.find(name, at + 1)) {
    text.erase(at + name.size(), text.find('"', at + name.size()) - at - name.size());
  }
  return text;
}

/// By their path in post.
std::set<std::string> files_of(const LiggghtsCase& c) {
  std::set<std::string> files;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(c.folder() / "post")) {
    if (!entry.is_regular_file()) continue;
    files.insert(std::filesystem::relative(entry.path(), c.folder() / "post").string());
  }
  return files;
}

constexpr const char* kGasOfTest = "interval=1e-5 wind=0.1,0,0 drag=1e-7";

TEST(CoupleWorld, EveryDumpIsTheSameInOneMpirunAsInTwoJobs) {
  // Two jobs have a world each.
  const LiggghtsCase jobs("couple_dumps_socket");
  const Outcome apart = jobs.couple(dumping_script(jobs, " transport socket rendezvous meet"),
                                    {kGasOfTest, 1, 1, true});
  ASSERT_EQ(apart.status, 0) << apart.output;
  const std::set<std::string> expected = files_of(jobs);
  ASSERT_GT(expected.size(), 40u);

  const LiggghtsCase one("couple_dumps");
  LiggghtsCase::Coupled how{kGasOfTest, 1, 1};
  how.program = LiggghtsCase::Program::preload;
  Outcome o = one.couple(dumping_script(one, ""), how);
  ASSERT_EQ(o.status, 0) << o.output;
  EXPECT_NE(o.output.find("fake solver: orderly end"), std::string::npos) << o.output;
  EXPECT_NE(o.output.find("Modify   time [0]"), std::string::npos) << o.output;
  EXPECT_EQ(files_of(one), expected);
  for (const std::string& file : expected) {
    if (file.find("own.") == 0 || file == "at_the_end") continue;  // hold the case's name
    EXPECT_TRUE(text_of(one, file) == text_of(jobs, file)) << file;
  }

  // On two ranks the particles come in another order.
  const LiggghtsCase two("couple_dumps_2_2");
  o = two.couple(dumping_script(two, ""), {kGasOfTest, 2, 2});
  ASSERT_EQ(o.status, 0) << o.output;
  EXPECT_NE(o.output.find("Modify   time [1]"), std::string::npos) << o.output;
  EXPECT_EQ(files_of(two), expected);
  EXPECT_NE(text_of(two, "particles_20.vtk").find("POINTS 8 "), std::string::npos);
  for (const char* file : {"particles_20.vtp", "particles_20.vtu", "atom_20.vtk"}) {
    EXPECT_NE(text_of(two, file).find("NumberOfPoints=\"8\""), std::string::npos) << file;
  }
}

/// The two programs pair their ranks: LIGGGHTS's own ways to divide or reorder them are refused.
TEST(CoupleWorld, PartitionsAndOtherOrdersOfRanksAreRefusedAtOnce) {
  for (const char* option : {"-partition 1 1", "-p 2x1", "-reorder nth 2"}) {
    const LiggghtsCase c("couple_partitions");
    c.write_spheres("spheres.data", {grain(0.0)}, 1e-2);
    LiggghtsCase::Coupled how{kGasOfTest, 2, 1};
    how.options = option;
    const Outcome o = c.couple(header(soft_spheres(), "spheres.data") + kGas + "run 20\n", how);
    EXPECT_NE(o.status, 0) << option;
    EXPECT_LT(o.status, 124) << option << '\n' << o.output;
    const std::string word = std::string(option).substr(0, std::string(option).find(' '));
    const std::string message = "ERROR: LIGGGHTS and solver in one mpirun; given: " + word +
                                "; allowed: all ranks of LIGGGHTS in one world";
    const auto at = o.output.find(message);
    EXPECT_NE(at, std::string::npos) << o.output;
    EXPECT_EQ(o.output.find("ERROR: ", at + 1), std::string::npos) << "said twice\n" << o.output;
  }
}

/// Alone, LIGGGHTS divides its ranks as ever.
TEST(CoupleWorld, PartitionsOfAnUncoupledRunStay) {
  const LiggghtsCase c("partitions_alone");
  c.write_spheres("spheres.data", {grain(0.0)}, 1e-2);
  const Outcome o =
      c.run(header(soft_spheres(), "spheres.data") + "fix integrate all nve/sphere\nrun 20\n", 2,
            LiggghtsCase::Program::launcher, "-partition 1 1");
  EXPECT_EQ(o.status, 0) << o.output;
  EXPECT_NE(o.output.find("Running on 2 partitions"), std::string::npos) << o.output;
}

}  // namespace
}  // namespace powderlink::testing
