// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/kat/study/measurements.h"

#include <gtest/gtest.h>

#include "analysis/kat/study/checks.h"
#include "tests/base/test_files.h"

namespace powderlink::analysis {
namespace {

Measurements read(const std::string& text) {
  const TestFolder folder;
  return read_measurements(folder.write("drop.csv", text));
}

void refused(const std::string& text, const std::vector<std::string>& fragments) {
  expect_refusal([&] { read(text); }, fragments);
}

const std::string kHeader = "impact_velocity_m_s,critical_diameter_um\n";

TEST(Measurements, ReadsTheContract) {
  const Measurements m = read(
      "\xEF\xBB\xBF# a comment\r\n"
      "impact_velocity_m_s, critical_diameter_um,critical_diameter_sigma_um,contact_time_us,\"who, "
      "where\"\r\n"
      "\r\n"
      " 1.8 ,66.4,1.5,100,\"me, here\"\r\n"
      "# another\r\n"
      "+2.3,6.38e1,2,90,you\r\n");
  ASSERT_EQ(m.rows.size(), 2U);
  EXPECT_EQ(m.rows[0].impact_velocity_m_s, 1.8);
  EXPECT_EQ(m.rows[0].critical_diameter_um, 66.4);
  EXPECT_EQ(m.rows[0].critical_diameter_sigma_um, 1.5);
  EXPECT_EQ(m.rows[0].contact_time_us, 100.0);
  EXPECT_FALSE(m.rows[0].adhesive_energy_J_m2.has_value());
  EXPECT_EQ(m.rows[1].impact_velocity_m_s, 2.3);
  EXPECT_EQ(m.rows[1].critical_diameter_um, 63.8);
  ASSERT_EQ(m.unknown_columns.size(), 1U);
  EXPECT_EQ(m.unknown_columns[0], "who, where");
  EXPECT_EQ(m.table.rows[0].cells[4], "me, here");
}

TEST(Measurements, ShippedFilesAreRead) {
  EXPECT_EQ(read_measurements(POWDERLINK_CASES "/zafar2014/zafar2014_drop_test.csv").rows.size(),
            7U);
  const Measurements glass =
      read_measurements(POWDERLINK_CASES "/pedrolli_316L_glass/kat_316L_glass.csv");
  EXPECT_EQ(glass.rows[1].adhesive_energy_J_m2, 102.84);
}

TEST(Measurements, EmptyAndBrokenFiles) {
  expect_refusal([] { read_measurements("not_there.csv"); }, {"not_there.csv"});
  refused("", {"drop.csv, line 1", "an empty file"});
  refused("# only a comment\n", {"an empty file"});
  refused(kHeader, {"drop.csv, line 1", "a header without rows"});
  refused("impact_velocity_m_s,impact_velocity_m_s\n1,2\n", {"line 1", "twice"});
  refused("impact_velocity_m_s,diameter\n1,2\n", {"critical_diameter_um", "diameter"});
  refused("impact_velocity_m_s:critical_diameter_um\n1:2\n", {"commas, semicolons or tabs"});
  refused("v,d\n1,2\n", {"'impact_velocity_m_s', 'critical_diameter_um'"});
  refused(kHeader + "1.8,66.4\n2.3\n", {"drop.csv, line 3, column 2", "1 cells"});
  refused(kHeader + "1,8,66,4\n", {"drop.csv, line 2, column 3", "decimal commas"});
}

TEST(Measurements, ValuesThatCannotBe) {
  const auto row = [](const std::string& cells) { return kHeader + "2.3,63.8\n" + cells + "\n"; };
  refused(row("fast,60"), {"drop.csv, line 3, column 'impact_velocity_m_s'", "'fast'"});
  refused(row("1.8m,60"), {"'1.8m'"});
  refused(row(",60"), {"an empty cell"});
  refused(row("nan,60"), {"'nan'", "finite"});
  refused(row("1.8,inf"), {"column 'critical_diameter_um'", "'inf'"});
  refused(row("0,60"), {"line 3", "0 m/s"});
  refused(row("-1,60"), {"-1 m/s"});
  refused(row("1800,60"), {"mm/s"});
  refused(row("1.8,0"), {"0 um"});
  refused(row("1.8,-5"), {"-5 um"});
  refused(row("1.8,66.4e-6"), {"metres", "write 66.4"});
  refused("impact_velocity_m_s,critical_diameter_um,contact_time_us\n1.8,60,1e-4\n",
          {"seconds", "write 100"});
  refused("impact_velocity_m_s,critical_diameter_um,critical_diameter_sigma_um\n1.8,60,0\n",
          {"standard deviation"});
  refused("impact_velocity_m_s,critical_diameter_um,adhesive_energy_J_m2\n1.8,60,-3\n",
          {"adhesive energy"});
}

/// One table as a spreadsheet, a notebook and a plotting program would save it.
TEST(Measurements, NamesAndUnitsInOtherForms) {
  for (const char* text :
       {"impact_velocity_m_s;critical_diameter_um\n1,8;66,4\n2,3;63,8\n",
        "Impact velocity [m/s]\tCritical diameter (\u00B5m)\n1,8\t66,4\n2,3\t63,8\n",
        "impact_velocity,critical_diameter\nm/s,um\n1.8,66.4\n2.3,63.8\n",
        "impact_velocity_m_s,critical_diameter_um\nm/s,um\n1.8,66.4 # first\n2.3,63.8\n",
        "Impact velocity (m s^-1);Critical diameter (\xB5m)\r1,8;66,4\r2,3;63,8\r"}) {
    const Measurements m = read(text);
    ASSERT_EQ(m.rows.size(), 2U) << text;
    EXPECT_EQ(m.rows[0].impact_velocity_m_s, 1.8);
    EXPECT_EQ(m.rows[1].critical_diameter_um, 63.8);
    EXPECT_TRUE(m.unknown_columns.empty());
    EXPECT_TRUE(m.notes.empty());
  }
  refused("impact_velocity_m_s,Critical diameter [mm]\n1,2\n",
          {"'critical_diameter_um'", "is in mm, not um", "give the values in the unit"});
  refused("impact_velocity_m_s,critical diameter\n1,2\n", {"has no unit"});
  refused("impact_velocity_m_s,critical_diameter_um\nm/s,mm\n1,2\n",
          {"row of units, column 'critical_diameter_um'", "mm", "um"});
}

TEST(Measurements, UnitsThatAreAThousandOffAreAskedFor) {
  const auto note = [](const std::string& text) {
    const Measurements m = read(text);
    return m.notes.empty() ? std::string() : m.notes[0];
  };
  EXPECT_EQ(note(kHeader + "1.8,66.4\n2.3,63.8\n"), "");
  EXPECT_EQ(note(kHeader + "1.8,0.5\n2.3,1.2\n"), "");  // small grains, not all below 1 um
  const std::string mm = note(kHeader + "1.8,0.0664\n2.3,0.0638\n");
  for (const char* part : {"critical_diameter_um", "were mm given", "66.4 for 0.0664"})
    EXPECT_NE(mm.find(part), std::string::npos) << mm;
  EXPECT_NE(note(kHeader + "1.8,6640\n2.3,6380\n").find("were nm given"), std::string::npos);
  EXPECT_NE(note(kHeader + "180,66.4\n230,63.8\n").find("were mm/s given"), std::string::npos);
  EXPECT_NE(note("impact_velocity_m_s,critical_diameter_um,contact_time_us\n1.8,66,0.1\n")
                .find("were ms given"),
            std::string::npos);
  EXPECT_NE(note("impact_velocity_m_s,diameter_um,count_before,count_after\n1.8,0.05,9,3\n")
                .find("were mm given"),
            std::string::npos);
  refused(kHeader + "1.8,0.0066\n", {"millimetres", "write 6.6"});
  // Rows of one table in two units.
  const std::string some = note(kHeader + "1.8,0.0664\n2.3,0.0638\n3,59.8\n4.1,53\n");
  for (const char* part : {"critical_diameter_um", "were mm given in some rows", "66.4 for 0.0664"})
    EXPECT_NE(some.find(part), std::string::npos) << some;
  EXPECT_NE(note(kHeader + "0.25,66.4\n230,63.8\n300,59.8\n").find("mm/s given in some rows"),
            std::string::npos);
  EXPECT_EQ(note(kHeader + "0.05,900\n9,4\n"), "");     // far apart, but not by a thousand
  EXPECT_EQ(note(kHeader + "1,0.5\n2,5\n3,50\n"), "");  // no gap
}

TEST(Checks, LargeAdhesiveEnergyWarnsAboutTheConvention) {
  EXPECT_TRUE(adhesive_energy_warning(10.0, "here").empty());
  const std::string warning = adhesive_energy_warning(17.0, "here");
  for (const char* fragment : {"here", "17", "work of adhesion", "surface energy", "0.01 to 1"}) {
    EXPECT_NE(warning.find(fragment), std::string::npos) << warning;
  }
}

}  // namespace
}  // namespace powderlink::analysis
