// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/flow/foam/foam_files.h"

#include <zlib.h>

#include <cstdio>

#include "tests/analysis/flow/flow_case.h"

namespace powderlink::analysis {
namespace {

namespace fs = std::filesystem;

/// Everything that a dictionary may have, with rho = 1.25 in the end.
const char* const kDictionary =
    "/* rho 998;\n   rho 997;\n*/\n"
    "FoamFile { version 2.0; format ascii; class dictionary; object transportProperties; }\n"
    "#include \"values\"\n"
    "rho 998; nu 1e-5; // rho 3;\n"
    "\"(start|stop)From\" byPattern; quoted \"a ; b\"; \"rho.*\" 77;\n"
    "gas { rho 5; hot { T $warm; } }\n"
    "gas { nu 2e-5; }\n"
    "list ( 1 2 { rho 4; } ); made #calc \"1 + 1\"; viaMade $made;\n"
    "stream #codeStream { code #{ os << 4; rho 3; #}; };\n"
    "#ifeq $name argon\n"
    "rho [1 -3 0 0 0 0 0]\n  $light;\n"
    "#else\n"
    "rho 996;\n"
    "#endif\n"
    "#remove list\n";
const char* const kValues = "light 1.25; name argon; /*\nlight 7; */ warm 350;";

class FoamFiles : public ::testing::Test {
 protected:
  void SetUp() override {
    write_in(folder_, "constant/values", kValues);
    write_in(folder_, "constant/transportProperties", kDictionary);
  }
  std::optional<FoamEntry> entry(const std::string& name,
                                 const std::string& file = "constant/transportProperties") {
    return read_foam_entry(folder_.path(), {file, name});
  }
  TestFolder folder_;
};

TEST_F(FoamFiles, EntriesAreWhatOpenFoamSees) {
  POWDERLINK_NEEDS_FOAM();
  // Without code, whose conditions could go either way.
  std::string plain = kDictionary;
  for (const char* code : {"made #calc \"1 + 1\"; viaMade $made;\n",
                           "stream #codeStream { code #{ os << 4; rho 3; #}; };\n"}) {
    plain.erase(plain.find(code), std::string(code).size());
  }
  write_in(folder_, "constant/transportProperties", plain);
  EXPECT_EQ(entry("rho")->number, 1.25);
  EXPECT_EQ(entry("nu")->number, 1e-5);
  EXPECT_EQ(entry("gas/rho")->number, 5.0);
  EXPECT_EQ(entry("gas/nu")->number, 2e-5);
  EXPECT_EQ(entry("gas/hot/T")->number, 350.0);
  EXPECT_EQ(entry("startFrom")->text, "byPattern");
  EXPECT_EQ(entry("rhoOfSolid")->number, 77.0);
  EXPECT_FALSE(entry("quoted")->number);
  EXPECT_FALSE(entry("list"));
  EXPECT_FALSE(entry("nothing"));
  EXPECT_FALSE(entry("rho", "constant/none"));
}

/// The same from foamDictionary, which comes with OpenFOAM's libraries.
TEST_F(FoamFiles, AgreesWithFoamDictionary) {
  POWDERLINK_NEEDS_FOAM();
  std::string plain = kDictionary;
  plain.erase(plain.find("made #calc"), plain.find("#ifeq") - plain.find("made #calc"));
  write_in(folder_, "constant/transportProperties", plain);
  for (const char* name : {"rho", "nu", "startFrom", "quoted", "gas/hot/T", "rhoOfSolid"}) {
    const std::string command =
        "cd '" + folder_.path().string() +
        "' && WM_PROJECT_DIR=${WM_PROJECT_DIR:-/usr/share/openfoam} foamDictionary -entry " + name +
        " -value constant/transportProperties 2>/dev/null";
    FILE* pipe = popen(command.c_str(), "r");
    ASSERT_NE(pipe, nullptr);
    char line[200] = "";
    ASSERT_NE(std::fgets(line, sizeof line, pipe), nullptr) << name;
    pclose(pipe);
    EXPECT_EQ(entry(name)->text + "\n", line) << name;
  }
}

TEST_F(FoamFiles, CodeIsNeitherRunNorTakenForAValue) {
  POWDERLINK_NEEDS_FOAM();
  write_in(folder_, "constant/transportProperties",
           "made #calc \"1 + 1\"; viaMade $made; nu 1e-5;\n"
           "stream #codeStream { code #{ os << 4; #}; };\nrho 1.25;\n");
  EXPECT_EQ(entry("rho")->number, 1.25);
  EXPECT_EQ(entry("nu")->number, 1e-5);
  for (const char* name : {"made", "viaMade", "stream"}) {
    expect_refusal([&] { entry(name); }, {name, "#codeStream", "not run"});
  }
  // A condition may hang on code.
  write_in(folder_, "constant/transportProperties",
           "made #calc \"1 + 1\";\n#ifeq $made 2\nrho 1;\n#else\nrho 2;\n#endif\n");
  expect_refusal([&] { entry("rho"); }, {"rho", "not run"});
  write_in(folder_, "constant/transportProperties", "#calc \"1 + 1\"\nrho 1;\n");
  expect_refusal([&] { entry("rho"); }, {"rho", "not run"});
}

TEST_F(FoamFiles, CompressedFilesAndPathsOfTheCase) {
  POWDERLINK_NEEDS_FOAM();
  const gzFile out = gzopen((folder_.path() / "constant/other.gz").c_str(), "wb");
  gzputs(out, "#include \"$FOAM_CASE/constant/values\"\nT $warm;\n");
  gzclose(out);
  EXPECT_EQ(entry("T", "constant/other")->number, 350.0);
  write_in(folder_, "constant/other", "#include \"<constant>/values\"\nT #eval \"2*$warm\";\n");
  EXPECT_EQ(entry("T", "constant/other")->number, 700.0);
}

TEST_F(FoamFiles, RefusesWhatOpenFoamCannotRead) {
  POWDERLINK_NEEDS_FOAM();
  write_in(folder_, "constant/transportProperties", "rho 1.2;\nnu { a 1;\n");
  expect_refusal([&] { entry("rho"); }, {"constant/transportProperties", "correct the file"});
  write_in(folder_, "constant/transportProperties", "#include \"nowhere\"\n");
  expect_refusal([&] { entry("rho"); }, {"nowhere"});
  write_in(folder_, "constant/transportProperties", "#include \"transportProperties\"\n");
  expect_refusal([&] { entry("rho"); }, {"includes itself"});
  EXPECT_FALSE(read_foam_entries(folder_.path(), {{"constant/none", "a"}}).front());
}

/// Text before, and after `startFrom latestTime`; empty: stays.
struct Change {
  const char* before;
  const char* after;
};

TEST_F(FoamFiles, ChangesOneEntryAndNothingElse) {
  POWDERLINK_NEEDS_FOAM();
  const Change changes[] = {
      {"startFrom   startTime ; endTime 1;\n", "startFrom   latestTime; endTime 1;\n"},
      {"a 1; startFrom /* x */ startTime; // startFrom y;\n",
       "a 1; startFrom latestTime; // startFrom y;\n"},
      {"startFrom firstTime;\nstartFrom startTime;\n",
       "startFrom firstTime;\nstartFrom latestTime;\n"},
      {"startFrom startTime;\nstartFrom latestTime;\n", ""},
      {"/* startFrom\nstartTime; */ startFrom $from; from startTime;\n", nullptr},
      {"from startTime; startFrom $from;", "from startTime; startFrom latestTime;"},
      {"f { startFrom startTime; }\nstartTime 0;\n",
       "f { startFrom startTime; }\nstartTime 0;\nstartFrom       latestTime;\n"},
      {"\"start.*\" 0;", "\"start.*\" 0;\nstartFrom       latestTime;\n"},
      // Another entry repeats it: only the end of the file leaves that alone.
      {"startFrom startTime;\nalso $startFrom;\n",
       "startFrom startTime;\nalso $startFrom;\nstartFrom       latestTime;\n"},
      {"#include \"values\"\nendTime $light;\n",
       "#include \"values\"\nendTime $light;\nstartFrom       latestTime;\n"},
      {"#includeIfPresent \"none\"\nstartFrom startTime;\r\nendTime 1;\r\n",
       "#includeIfPresent \"none\"\nstartFrom latestTime;\r\nendTime 1;\r\n"},
  };
  for (const Change& change : changes) {
    write_in(folder_, "constant/control", change.before);
    const auto set = [&] {
      return change_foam_entry(folder_.path(), {"constant/control", "startFrom"}, "latestTime");
    };
    if (change.after == nullptr) {
      // An undefined macro: OpenFOAM refuses the file itself.
      expect_refusal(set, {"constant/control"});
      continue;
    }
    const auto text = set();
    EXPECT_EQ(text.value_or(""), change.after) << change.before;
    EXPECT_EQ(read_file(folder_.path() / "constant/control"), change.before);
    if (!text) continue;
    write_in(folder_, "constant/control", *text);
    EXPECT_FALSE(set()) << change.before;
  }
}

TEST_F(FoamFiles, BoxOfAMeshInProcessorsToo) {
  POWDERLINK_NEEDS_FOAM();
  EXPECT_FALSE(foam_mesh_extent(folder_.path()));
  const std::string head =
      "FoamFile { version 2.0; format ascii; class vectorField; location \"constant/polyMesh\"; "
      "object points; }\n";
  write_in(folder_, "processor0/constant/polyMesh/points", head + "2((0 0 0) (1 2 0.02))\n");
  write_in(folder_, "processor1/constant/polyMesh/points", head + "2((0 0 0.02) (1 2 0.04))\n");
  const auto box = foam_mesh_extent(folder_.path());
  ASSERT_TRUE(box);
  EXPECT_EQ(box->low_m, (std::array<double, 3>{0.0, 0.0, 0.0}));
  EXPECT_EQ(box->high_m, (std::array<double, 3>{1.0, 2.0, 0.04}));
}

}  // namespace
}  // namespace powderlink::analysis
