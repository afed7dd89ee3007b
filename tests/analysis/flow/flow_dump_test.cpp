// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/flow/run/particle_dump.h"

#include "tests/analysis/flow/flow_case.h"

namespace powderlink::analysis {
namespace {

std::vector<DumpState> read_all(const std::filesystem::path& file) {
  std::vector<DumpState> states;
  read_dump(file, [&](const DumpState& state) { states.push_back(state); });
  return states;
}

TEST(ParticleDump, ReadsColumnsByNameAndSeveralStates) {
  const TestFolder folder;
  // Other order, a column that nobody asked for, a time of its own, blanks in excess.
  const std::string text =
      "ITEM: TIMESTEP\n7\nITEM: TIME\n0.25\nITEM: NUMBER OF ATOMS\n1\nITEM: BOX BOUNDS ff ff ff\n"
      "0 1\n0 1\n0 1\nITEM: ATOMS mass radius f_fluid[1] vz vy vx z y x id \n"
      "1e-9  3e-05 nan 6 5 4 3 2 1 42 \n";
  const auto states = read_all(folder.write("a.dump", text + dump_text(9, stream_at(0))));
  ASSERT_EQ(states.size(), 2U);
  EXPECT_EQ(states[0].step, 7);
  EXPECT_EQ(states[0].time_s, 0.25);
  const DumpParticle& p = states[0].particles.at(0);
  EXPECT_EQ(p.id, 42);
  EXPECT_EQ(p.x_m + 10 * p.y_m + 100 * p.z_m, 321.0);
  EXPECT_EQ(p.vx_m_s + 10 * p.vy_m_s + 100 * p.vz_m_s, 654.0);
  EXPECT_EQ(p.mass_kg, 1e-9);
  EXPECT_EQ(states[1].particles.size(), static_cast<std::size_t>(kStreamParticles));
  EXPECT_FALSE(states[1].time_s);
}

TEST(ParticleDump, ListsByStepNotByName) {
  const TestFolder folder;
  for (const char* name : {"1000", "200", "30"}) {
    write_in(folder, std::string("post/particles_") + name + ".dump", "");
  }
  write_in(folder, "post/walls_1.dump", "");
  const auto dumps = list_dumps(folder.path());
  ASSERT_EQ(dumps.size(), 3U);
  EXPECT_EQ(step_of_name(dumps[0]), 30);
  EXPECT_EQ(step_of_name(dumps[2]), 1000);
}

TEST(ParticleDump, RefusesWhatBreaksOffOrIsNoNumber) {
  const TestFolder folder;
  const std::string good = dump_text(0, stream_at(0));
  const auto refuse = [&](const std::string& text, const std::vector<std::string>& fragments) {
    expect_refusal([&] { read_all(folder.write("a.dump", text)); }, fragments);
  };
  const auto with = [&good](const std::string& from, const std::string& to) {
    std::string text = good;
    return text.replace(text.find(from), from.size(), to);
  };
  refuse("", {"empty"});
  refuse(good.substr(0, good.size() / 2), {"line "});
  refuse(good.substr(0, 60), {"breaks off"});
  refuse(with(" mass", ""), {"no column mass"});
  refuse(with("3e-05", "3e-0x"), {"'3e-0x'", "line 10"});
  refuse(with("3e-05", "-3e-05"), {"radius -3e-05"});
  refuse(with("3e-05 ", ""), {"fewer values"});
  refuse(with("3e-05 ", "3e-05 3e-05 "), {"more values"});
  refuse(with("3000", "-3"), {"-3 atoms"});
  refuse(with("ITEM: TIMESTEP", "ITEM: STEP"), {"ITEM: STEP"});
  expect_refusal([&] { list_dumps(folder.path()); }, {"particles_*.dump"});
  expect_refusal([&] { read_all(folder.path() / "none.dump"); }, {"none.dump"});
}

}  // namespace
}  // namespace powderlink::analysis
