// SPDX-License-Identifier: GPL-3.0-or-later
#include <unistd.h>
#include <zlib.h>

#include <cstdint>

#include "analysis/flow/restart/checkpoints.h"
#include "analysis/flow/restart/prepare.h"
#include "tests/analysis/flow/flow_case.h"

namespace powderlink::analysis {
namespace {

namespace fs = std::filesystem;

constexpr double kTimeStep_s = 2e-7;
const char* const kClosed = "FoamFile {}\n1\n\n// ***************************************** //\n";
const char* const kControl =
    "#include \"caseSettings\"\nstartFrom         startTime;\nstartTime         0;\n"
    "stopAt endTime;\n";

/// A LIGGGHTS 3.8 restart file of some ranks with some atoms each, with a middle that nobody reads here.
std::string restart_text(std::int64_t step, int ranks = 2, int atoms = 3) {
  std::string text;
  const auto add = [&text](auto value) {
    text.append(reinterpret_cast<const char*>(&value), sizeof(value));
  };
  const auto add_text = [&](std::int32_t item, const std::string& value) {
    add(item);
    add(static_cast<std::int32_t>(value.size() + 1));
    text += value + '\0';
  };
  add_text(0, "Version LIGGGHTS-PUBLIC 3.8.0");
  for (const std::int32_t item : {1, 2, 3}) {
    add(item);
    add(std::int32_t{4});
  }
  add_text(4, "si");
  add(std::int32_t{5});
  add(step);
  for (std::int32_t item = 6; item < 22; ++item) {
    add(item);
    add(std::int32_t{item == 7 ? ranks : 1});
  }
  add_text(22, "granular");
  add(std::int32_t{23});
  add(static_cast<std::int64_t>(ranks) * atoms);
  add(std::int32_t{-1});
  text += std::string(1000, 'x') + std::string(100, '\0');
  constexpr int doubles = 17;
  for (int rank = 0; rank < ranks; ++rank) {
    add(std::int32_t{doubles * atoms});
    for (int i = 0; i < doubles * atoms; ++i) add(i % doubles == 0 ? double{doubles} : 0.1 * i);
  }
  return text;
}

class Restart : public ::testing::Test {
 protected:
  void SetUp() override {
    write_in(folder_, "in.pipe", "timestep 2e-7\n");
    write_in(folder_, "system/controlDict", kControl);
    write_in(folder_, "system/caseSettings", "endTime 0.1;\n");
    write_in(folder_, "0/U", "no last line");
    for (const int k : {1, 2, 3}) {
      fields(time(k));
      dem(50000L * k);
    }
  }
  static std::string time(int k) { return fmt::format("{:g}", 0.01 * k); }
  void fields(const std::string& name, const std::string& root = "") {
    for (const char* field : {"U", "p", "phi", "alphaf", "nut"}) {
      write_in(folder_, root + name + "/" + field, kClosed);
    }
  }
  void dem(long step) {
    write_in(folder_, fmt::format("post/restart.{}", step), restart_text(step));
  }
  Checkpoints find() const { return find_checkpoints(folder_.path(), {}); }
  void expect_last(const std::string& name, long step, const std::string& reason) const {
    const Checkpoints found = find();
    ASSERT_TRUE(found.last);
    EXPECT_EQ(found.last->fields.name, name);
    EXPECT_EQ(found.last->dem.step, step);
    std::string all;
    for (const std::string& line : found.refused()) all += line + "\n";
    EXPECT_NE(all.find(reason), std::string::npos) << all;
  }
  TestFolder folder_;
};

TEST_F(Restart, TakesTheLatestCompletePair) {
  expect_last("0.03", 150000, "");
  EXPECT_TRUE(find().refused().empty());
}

TEST_F(Restart, HalfWrittenFields) {
  write_in(folder_, "0.03/phi", std::string(kClosed).substr(0, 30));
  expect_last("0.02", 100000, "0.03/phi breaks off");
  write_in(folder_, "0.03/phi", "");
  expect_last("0.02", 100000, "0.03/phi is empty");
  fs::remove(folder_.path() / "0.03/phi");
  expect_last("0.02", 100000, "0.03/phi is missing");
}

/// Of what gzip makes of a text.
std::string compressed(const std::string& text) {
  const fs::path file = fs::temp_directory_path() / fmt::format("restart_test.{}.gz", ::getpid());
  const gzFile out = gzopen(file.c_str(), "wb");
  gzwrite(out, text.data(), static_cast<unsigned>(text.size()));
  gzclose(out);
  std::string bytes = read_file(file);
  fs::remove(file);
  return bytes;
}

TEST_F(Restart, CompressedFieldsAreReadToTheirEnd) {
  // Numbers that do not compress to nothing, longer than a block of the reader.
  std::string field = "FoamFile {}\n";
  for (unsigned i = 1; i < 20000; ++i) field += fmt::format("{}\n", i * 2654435761U);
  const std::string whole = compressed(field + kClosed);
  ASSERT_GT(whole.size(), std::size_t{1} << 16);
  fs::remove(folder_.path() / "0.03/phi");
  const auto phi = [&](const std::string& bytes) { write_in(folder_, "0.03/phi.gz", bytes); };

  phi(whole);
  expect_last("0.03", 150000, "");
  for (const std::size_t bytes : {std::size_t{19}, whole.size() / 2, whole.size() - 1}) {
    phi(whole.substr(0, bytes));
    expect_last("0.02", 100000, "0.03/phi breaks off: it cannot be decompressed");
  }
  std::string damaged = whole;
  damaged[whole.size() / 2] = static_cast<char>(damaged[whole.size() / 2] ^ 1);
  phi(damaged);
  expect_last("0.02", 100000, "0.03/phi breaks off: it cannot be decompressed");
  phi(field + kClosed);  // nothing that OpenFOAM would write under this name
  expect_last("0.02", 100000, "0.03/phi breaks off: it cannot be decompressed");
  phi(compressed(field));
  expect_last("0.02", 100000, "0.03/phi breaks off: OpenFOAM's last line");
}

TEST_F(Restart, RestartFilesMayBeginAsTheFixSays) {
  POWDERLINK_NEEDS_FOAM();
  fs::create_directories(folder_.path() / "checkpoints");
  for (const int k : {1, 2}) {
    fs::rename(folder_.path() / fmt::format("post/restart.{}", 50000 * k),
               folder_.path() / fmt::format("checkpoints/bed_{}", 50000 * k));
  }
  const Checkpoints found = find_checkpoints(folder_.path(), {}, "checkpoints/bed_");
  ASSERT_TRUE(found.last);
  EXPECT_EQ(found.last->dem.step, 100000);
  ASSERT_EQ(found.refused().size(), 1U);
  EXPECT_NE(found.refused()[0].find("no checkpoints/bed_150000"), std::string::npos);
  prepare_restart(folder_.path(), found);
  EXPECT_EQ(fs::read_symlink(folder_.path() / "checkpoints/bed_latest"), "bed_100000");
  expect_refusal([&] { require_checkpoints(folder_.path(), {}, "other/"); },
                 {"no other/50000", "--checkpoint PREFIX"});
}

TEST_F(Restart, HalfWrittenOrForeignRestartFiles) {
  write_in(folder_, "post/restart.150000", "");
  expect_last("0.02", 100000, "restart.150000 is empty");
  const std::string whole = restart_text(150000);
  for (const std::size_t bytes : {std::size_t{60}, whole.size() / 2, whole.size() - 17 * 3 * 8 - 4,
                                  whole.size() - 8, whole.size() - 1}) {
    write_in(folder_, "post/restart.150000", whole.substr(0, bytes));
    expect_last("0.02", 100000, "breaks off");
  }
  // As a file system may leave it: the length is right, the second half is not written.
  write_in(folder_, "post/restart.150000",
           whole.substr(0, whole.size() / 2) + std::string(whole.size() - whole.size() / 2, '\0'));
  expect_last("0.02", 100000, "breaks off");
  write_in(folder_, "post/restart.150000", whole + "x");
  expect_last("0.02", 100000, "breaks off");
  for (const auto& [ranks, atoms] : {std::pair(1, 1), std::pair(1, 0), std::pair(3, 0)}) {
    write_in(folder_, "post/restart.150000", restart_text(150000, ranks, atoms));
    expect_last("0.03", 150000, "");
  }
  write_in(folder_, "post/restart.150000", restart_text(100000));
  expect_last("0.02", 100000, "holds step 100000");
  fs::rename(folder_.path() / "post/restart.150000", folder_.path() / "post/restart.150000.part");
  expect_last("0.02", 100000, "no post/restart.150000");
}

TEST_F(Restart, TimesThatDoNotMeet) {
  POWDERLINK_NEEDS_FOAM();
  fs::rename(folder_.path() / "post/restart.150000", folder_.path() / "post/restart.160000");
  write_in(folder_, "post/restart.160000", restart_text(160000));
  expect_last("0.02", 100000, "restart.160000: no fields of time 0.032 s");
  // One step off is another state.
  write_in(folder_, "post/restart.150001", restart_text(150001));
  write_in(folder_, "0.03/uniform/time", "value           0.03;\nname \"0.03\";\n");
  expect_last("0.02", 100000, "no post/restart.150000");
}

TEST_F(Restart, ClocksMayDifferByWhatTheSolverHasWritten) {
  POWDERLINK_NEEDS_FOAM();
  // The bed had settled for 0.01 s before: fields of 0.02 s belong to step 150000.
  for (const char* t : {"0.02", "0.03"}) {
    write_in(folder_, std::string(t) + "/momentumBalance", kClosed);
    write_in(folder_, std::string(t) + "/uniform/couplingClock",
             "FoamFile\n{\n}\nparticlesAhead  0.01;\n\n// *** //\n");
  }
  expect_last("0.02", 150000, "fields of time 0.03: no post/restart.200000");
  dem(200000);
  expect_last("0.03", 200000, "");
}

const char* const kClockFile =
    "FoamFile\n{\n}\nparticlesAhead  0;\n\nfiles           \"U alphaf k momentumBalance p phi\";\n"
    "\n// ************************************************************************* //\n";

TEST_F(Restart, AFileThatAllProcessorsMissIsKnown) {
  const auto root = [](int processor) { return fmt::format("processor{}/", processor); };
  const auto make = [&] {
    for (const int k : {1, 2, 3}) {
      for (const int processor : {0, 1}) {
        fields(time(k), root(processor));
        for (const char* more : {"/momentumBalance", "/k"}) {
          write_in(folder_, root(processor) + time(k) + more, kClosed);
        }
        write_in(folder_, root(processor) + time(k) + "/uniform/couplingClock", kClockFile);
      }
    }
  };
  make();
  expect_last("0.03", 150000, "");
  for (const char* lost : {"momentumBalance", "k", "uniform/couplingClock"}) {
    for (const int processor : {0, 1}) {
      fs::remove(folder_.path() / (root(processor) + "0.03/" + lost));
    }
    expect_last("0.02", 100000, fmt::format("processor0/0.03/{} is missing", lost));
    make();
  }
  // Nothing of it left but the times before, which have them.
  for (const int processor : {0, 1}) {
    fs::remove(folder_.path() / (root(processor) + "0.03/momentumBalance"));
    fs::remove_all(folder_.path() / (root(processor) + "0.03/uniform"));
  }
  expect_last("0.02", 100000, "processor0/0.03/uniform/couplingClock is missing");
  make();
  fs::remove(folder_.path() / "processor1/0.03/uniform/couplingClock");
  expect_last("0.02", 100000, "processor1/0.03/uniform/couplingClock is missing");
  write_in(folder_, "processor1/0.03/uniform/couplingClock", std::string(kClockFile).substr(0, 90));
  expect_last("0.02", 100000, "processor1/0.03/uniform/couplingClock breaks off");
  // Compressed, as with writeCompression.
  fs::remove(folder_.path() / "processor1/0.03/uniform/couplingClock");
  write_in(folder_, "processor1/0.03/uniform/couplingClock.gz", compressed(kClockFile));
  expect_last("0.03", 150000, "");
}

TEST_F(Restart, ClocksOfCompressedRunsAreRead) {
  std::string ahead = kClockFile;
  ahead.replace(ahead.find("  0;"), 4, "  0.01;");
  for (const char* t : {"0.02", "0.03"}) {
    write_in(folder_, std::string(t) + "/uniform/couplingClock.gz", compressed(ahead));
    for (const char* more : {"/momentumBalance", "/k"})
      write_in(folder_, t + std::string(more), kClosed);
  }
  expect_last("0.02", 150000, "fields of time 0.03: no post/restart.200000");
}

TEST_F(Restart, StaleProcessorsBesideNewerTimesOfOneRank) {
  for (const char* root : {"processor0/", "processor1/"}) fields(time(1), root);
  const Checkpoints found = find();
  ASSERT_TRUE(found.last);
  EXPECT_EQ(found.last->fields.name, "0.03");
  ASSERT_EQ(found.last->fields.folders.size(), 1U);
  EXPECT_EQ(found.last->fields.folders[0], folder_.path() / "0.03");
  for (const char* words : {"2 processor folder(s)", "time 0.01", "decomposePar -force"}) {
    EXPECT_NE(found.stale_processors().find(words), std::string::npos) << found.stale_processors();
  }
  prepare_restart(folder_.path(), found);
  EXPECT_TRUE(fs::exists(folder_.path() / "processor1/0.01/U"));
  // The newest of one rank is of no use: it is named, and so is what takes its place.
  fs::remove(folder_.path() / "0.03/p");
  expect_last("0.02", 100000, "0.03/p is missing");
  EXPECT_NE(find().stale_processors(), "");
  // Those of one rank are all of no use, and named.
  fs::remove(folder_.path() / "0.02/p");
  expect_last("0.01", 50000, "0.02/p is missing");
  EXPECT_EQ(find().last->fields.folders.size(), 2U);
  EXPECT_EQ(find().stale_processors(), "");
}

TEST_F(Restart, ReconstructedTimesBesideTheirProcessors) {
  for (const char* root : {"processor0/", "processor1/"}) {
    for (const int k : {1, 2, 3}) fields(time(k), root);
  }
  const Checkpoints found = find();
  ASSERT_TRUE(found.last);
  EXPECT_TRUE(found.last->fields.decomposed);
  EXPECT_EQ(found.stale_processors(), "");
}

TEST_F(Restart, RoundedNamesAreReadExactly) {
  POWDERLINK_NEEDS_FOAM();
  // Four digits in the name; the file in it says 0.06123444 s, which is step 306172.2.
  fields("0.06123");
  write_in(folder_, "0.06123/uniform/time", "value           0.06123444;\n");
  dem(306150);  // 0.06123 s
  dem(306173);  // 0.0612346 s
  expect_last("0.03", 150000, "no post/restart.306172");
  dem(306172);
  expect_last("0.06123", 306172, "");
}

TEST_F(Restart, NamesMayDropZerosAndRoundToSixDigits) {
  // Without the file uniform/time: 100001 steps are 0.0200002 s, a time of its own.
  dem(100001);
  fields("0.0200002");
  expect_last("0.03", 150000, "");
  // 12.3456789 s is written as 12.3457; half a unit of that digit is 5e-5 s.
  fields("12.3457");
  dem(61728395);
  expect_last("12.3457", 61728395, "");
}

TEST_F(Restart, EveryProcessorMustBeWhole) {
  for (const char* root : {"processor0/", "processor1/", "processor10/"}) {
    for (const int k : {1, 2, 3}) fields(time(k), root);
  }
  expect_last("0.03", 150000, "");
  EXPECT_EQ(find().last->fields.folders.size(), 3U);
  fs::remove(folder_.path() / "processor10/0.03/nut");
  expect_last("0.02", 100000, "processor10/0.03/nut is missing");
  fs::remove_all(folder_.path() / "processor1/0.02");
  expect_last("0.01", 50000, "processor1/0.02/U is missing");
}

TEST_F(Restart, NothingCompleteSaysWhatIsMissing) {
  for (const int k : {1, 2, 3}) fs::remove(folder_.path() / time(k) / "alphaf");
  expect_refusal([&] { require_checkpoints(folder_.path(), {}); },
                 {"0.03/alphaf is missing", "0.01/alphaf is missing", "start the run"});
  expect_refusal([&] { require_checkpoints(folder_.path() / "none", {}); }, {"opening the case"});
}

TEST_F(Restart, PrepareMovesAsideAndLinksButDeletesNothing) {
  POWDERLINK_NEEDS_FOAM();
  write_in(folder_, "0.03/phi", "");
  const auto count = [&] {
    std::size_t files = 0;
    for (const auto& entry : fs::recursive_directory_iterator(folder_.path())) {
      files += entry.is_regular_file() && !entry.is_symlink() ? 1 : 0;
    }
    return files;
  };
  const std::size_t before = count();
  for (int again = 0; again < 2; ++again) {
    prepare_restart(folder_.path(), find());
    EXPECT_EQ(count(), before);
    EXPECT_FALSE(fs::exists(folder_.path() / "0.03"));
    EXPECT_TRUE(fs::exists(folder_.path() / "discarded/0.03/phi"));
    EXPECT_EQ(fs::read_symlink(folder_.path() / "post/restart.latest"), "restart.100000");
    EXPECT_EQ(read_file(folder_.path() / "system/controlDict"),
              "#include \"caseSettings\"\nstartFrom         latestTime;\nstartTime         0;\n"
              "stopAt endTime;\n");
  }
  // The run is killed in the same way once more: both discarded states are kept.
  fields("0.03");
  write_in(folder_, "0.03/phi", "");
  prepare_restart(folder_.path(), find());
  EXPECT_TRUE(fs::exists(folder_.path() / "discarded/0.03.1/phi"));
}

TEST_F(Restart, PrepareOfProcessorsKeepsThemApart) {
  POWDERLINK_NEEDS_FOAM();
  for (const char* root : {"processor0/", "processor1/"}) {
    for (const int k : {1, 2, 3}) fields(time(k), root);
  }
  fs::remove_all(folder_.path() / "processor1/0.03");
  prepare_restart(folder_.path(), find());
  EXPECT_TRUE(fs::exists(folder_.path() / "discarded/processor0/0.03/U"));
  EXPECT_TRUE(fs::exists(folder_.path() / "processor0/0.02/U"));
}

TEST_F(Restart, PrepareRefusesBeforeItChangesAnything) {
  POWDERLINK_NEEDS_FOAM();
  write_in(folder_, "0.03/phi", "");
  write_in(folder_, "system/controlDict", "#include \"settings\"\n");
  expect_refusal([&] { prepare_restart(folder_.path(), find()); },
                 {"system/controlDict", "settings"});
  EXPECT_TRUE(fs::exists(folder_.path() / "0.03"));
  EXPECT_FALSE(fs::exists(folder_.path() / "post/restart.latest"));
}

TEST_F(Restart, PrepareKeepsLinksRightsAndWhatIsRight) {
  POWDERLINK_NEEDS_FOAM();
  // OpenFOAM's default is latestTime.
  const char* const quiet = "stopAt endTime; startTime 0; // startFrom startTime;\n";
  write_in(folder_, "system/controlDict", quiet);
  const fs::path control = folder_.path() / "system/controlDict";
  prepare_restart(folder_.path(), find());
  EXPECT_EQ(read_file(control), quiet);

  fs::rename(control, folder_.path() / "lent");
  write_in(folder_, "lent", "stopAt endTime; startFrom startTime; startTime 0;\n");
  fs::create_symlink("../lent", control);
  fs::permissions(folder_.path() / "lent", fs::perms::owner_read | fs::perms::owner_write);
  prepare_restart(folder_.path(), find());
  EXPECT_TRUE(fs::is_symlink(control));
  EXPECT_EQ(read_file(control), "stopAt endTime; startFrom latestTime; startTime 0;\n");
  EXPECT_EQ(fs::status(control).permissions(), fs::perms::owner_read | fs::perms::owner_write);
}

}  // namespace
}  // namespace powderlink::analysis
