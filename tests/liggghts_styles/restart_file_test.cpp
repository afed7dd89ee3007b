// SPDX-License-Identifier: GPL-3.0-or-later
// Restart files of the real LIGGGHTS, whole and damaged: what liggghts_styles/host/restart_file.h says of them, and what
// the two programs of a coupled job do when a script reads one.
#include "liggghts_styles/host/restart_file.h"

#include <fstream>
#include <iterator>

#include <gtest/gtest.h>

#include "couple_bridge_case.h"

namespace powderlink::testing {
namespace {

namespace fs = std::filesystem;

std::string bytes_of(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

void write_bytes(const fs::path& file, const std::string& bytes) {
  std::ofstream(file, std::ios::binary) << bytes;
}

/// Grains on one side of the box only, so that of two ranks one has none.
std::string write_lines(const LiggghtsCase& c, int ranks) {
  c.write_spheres("spheres.data", {grain(-4e-4), grain(-6e-4), grain(-8e-4)}, 1e-3);
  return (ranks == 2 ? "processors 2 1 1\n" : "") + header(soft_spheres(), "spheres.data") +
         "fix integrate all nve/sphere\nfix weight all gravity 9.81 vector 0 0 -1\nrun 10\n"
         "write_restart whole.rst\nwrite_restart part.%.rst\n";
}

TEST(RestartFile, OnlyWholeFilesOfLiggghtsAreWhole) {
  for (const int ranks : {1, 2}) {
    const LiggghtsCase c("restart_file_" + std::to_string(ranks));
    const Outcome o = c.run(write_lines(c, ranks), ranks);
    ASSERT_EQ(o.status, 0) << o.output;
    const fs::path single = c.folder() / "whole.rst";
    const fs::path many = c.folder() / "part.%.rst";
    EXPECT_EQ(why_not_whole_restart(single), "");
    EXPECT_EQ(why_not_whole_restart(many), "");
    EXPECT_EQ(read_restart_head(single).step, 10);
    EXPECT_EQ(read_restart_head(single).atoms, 3);
    EXPECT_EQ(read_restart_head(single).ranks, ranks);

    const std::string all = bytes_of(single);
    // The head has many zeros, which look like ranks without atoms: every length of it, and of the end.
    constexpr std::size_t head = 500;
    for (std::size_t length = 0;
         length<all.size(); length += length> head && length + 64 < all.size() ? 61 : 1) {
      write_bytes(single, all.substr(0, length));
      EXPECT_NE(why_not_whole_restart(single), "") << length << " of " << all.size();
    }
    write_bytes(single,
                all.substr(0, all.size() / 2) + std::string(all.size() - all.size() / 2, '\0'));
    EXPECT_NE(why_not_whole_restart(single), "");

    const fs::path first = c.folder() / "part.0.rst";
    const std::string block = bytes_of(first);
    for (const std::size_t length :
         {std::size_t{0}, std::size_t{3}, block.size() / 2, block.size() - 1}) {
      write_bytes(first, block.substr(0, length));
      EXPECT_NE(why_not_whole_restart(many).find("part.0.rst"), std::string::npos);
    }
    fs::remove(first);
    EXPECT_NE(why_not_whole_restart(many).find("part.0.rst is missing"), std::string::npos);
  }
}

/// One message in four parts, no hang, on any number of ranks, alone and in a coupled job.
TEST(RestartFile, ReadRestartRefusesWhatIsNotWhole) {
  const LiggghtsCase c("restart_file_read");
  Outcome o = c.run(write_lines(c, 1));
  ASSERT_EQ(o.status, 0) << o.output;
  const std::string all = bytes_of(c.folder() / "whole.rst");
  std::string script = header(soft_spheres(), "spheres.data") + kGas + "run 10\n";
  script.replace(script.find("read_data spheres.data"), 22, "read_restart post/restart.*");
  fs::create_directories(c.folder() / "post");
  const fs::path latest = c.folder() / "post/restart.10";
  write_bytes(c.folder() / "post/restart.5", all);
  const auto expect_refused = [&](const char* what) {
    EXPECT_NE(o.status, 0) << what;
    EXPECT_LT(o.status, 124) << what << "\n" << o.output;
    for (const char* words : {"ERROR: read_restart post/restart.*; given: post/restart.10 ",
                              "; allowed: a restart file", "; to do: take an earlier one"}) {
      const auto at = o.output.find(words);
      EXPECT_NE(at, std::string::npos) << what << words << "\n" << o.output;
      EXPECT_EQ(o.output.find(words, at + 1), std::string::npos) << what << o.output;
    }
  };
  write_bytes(latest, all.substr(0, all.size() / 2));
  for (const int ranks : {1, 2}) {
    o = c.couple(script, {interval() + "wind=1,0,0 drag=1e-6", ranks, 1});
    expect_refused("half, coupled");
  }
  for (const std::size_t length : {std::size_t{0}, std::size_t{50}, all.size() - 8}) {
    write_bytes(latest, all.substr(0, length));
    o = c.run(script, 2);
    expect_refused("alone");
  }
  fs::remove(latest);
  o = c.run(script);
  EXPECT_EQ(o.output.find("read_restart post/restart.*; given"), std::string::npos)
      << "the one before is whole" << o.output;
}

}  // namespace
}  // namespace powderlink::testing
