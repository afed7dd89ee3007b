// SPDX-License-Identifier: GPL-3.0-or-later
/// \file kat_device_test.cpp
/// The command `kat device`: velocities against free fall, their uncertainty against repeated drops,
/// the real core on a pseudo-terminal, damaged logs, and the way into a study.
#include <cmath>
#include <map>
#include <random>
#include <sstream>

#include "analysis/kat/device/device_velocity.h"
#include "analysis/kat/study/study.h"
#include "tests/analysis/program/command_line.h"
#include "tests/kat_firmware/simulated_device.h"

namespace powderlink::analysis {
namespace {

kat::Drop ideal_drop(double height_m, double noise_carrier_m = 0, double noise_beam_m = 0) {
  const double g = kat::kGravity_m_s2;
  const double h = 0.01 + noise_carrier_m, beam = 0.03 + noise_beam_m;
  kat::Drop d;
  d.number = 1;
  d.carrier_um = 10000;
  d.beam_um = 30000;
  d.latency_us = 66;
  const auto us = [](double s) { return static_cast<uint32_t>(std::lround(s * 1e6)); };
  d.enter_us = us(std::sqrt(2 * (height_m - beam) / g));
  d.leave_us = us(std::sqrt(2 * (height_m - beam + h) / g));
  d.touch_us = us(std::sqrt(2 * height_m / g));
  d.vibration_us = d.touch_us + 66;
  d.contacts.edge(true, d.touch_us, 5);
  d.contacts.edge(false, d.touch_us + 100, 5);
  return d;
}

TEST(DeviceVelocity, IsThatOfFreeFallByBeamAndByFlight) {
  constexpr double largest_error = 1e-3;  // demanded of the device; the clock counts microseconds
  for (const double height_m : {0.05, 0.1, 0.25, 0.5}) {
    const DeviceVelocity v = device_velocity(ideal_drop(height_m), {}, "test");
    const double fall = std::sqrt(2 * kat::kGravity_m_s2 * height_m);
    EXPECT_NEAR(v.value_m_s / fall, 1.0, largest_error);
    EXPECT_NEAR(*v.flight_m_s / fall, 1.0, largest_error);
    EXPECT_TRUE(v.consistent);
  }
}

/// The spread of many drops of carriers and beams that are off by chance is the stated uncertainty.
TEST(DeviceVelocity, UncertaintyIsTheSpreadOfRepeatedDrops) {
  constexpr int n = 4000;
  constexpr double tolerance =
      0.06;  // 1/sqrt(2 n) of a standard deviation is 0.011; rounding of 1 us
  const DeviceSigmas sigmas{50.0, 500.0, 0.3, 10.0};
  std::mt19937 random(11);
  std::normal_distribution<double> normal;
  double sum = 0, squares = 0;
  const double height_m = 0.2, truth = std::sqrt(2 * kat::kGravity_m_s2 * height_m);
  for (int i = 0; i < n; ++i) {
    const auto d = ideal_drop(height_m, 50e-6 * normal(random), 500e-6 * normal(random));
    const double off = device_velocity(d, sigmas, "test").value_m_s - truth;
    sum += off;
    squares += off * off;
  }
  const double spread = std::sqrt(squares / n - sum * sum / n / n);
  const double stated = device_velocity(ideal_drop(height_m), sigmas, "test").sigma_m_s;
  EXPECT_NEAR(spread / stated, 1.0, tolerance);
}

TEST(DeviceVelocity, RefusesWhatIsNoFallAndNamesDisagreement) {
  kat::Drop d = ideal_drop(0.2);
  d.leave_us = d.enter_us + 200000;
  expect_refusal([&] { device_velocity(d, {}, "here"); }, {"here", "200000 us"});
  d = ideal_drop(0.2);
  d.vibration_us += 5000;
  EXPECT_FALSE(device_velocity(d, {}, "test").consistent);
}

std::string text_of(const kat::Drop& d) {
  std::string text;
  for (uint8_t i = 0; i < d.lines(); ++i) {
    kat::LineWriter line = kat::drop_line(d, i);
    text += line.finish();
  }
  return text;
}

TEST(KatDevice, ALogBecomesAStudy) {
  const TestFolder folder;
  const std::string at = folder.path().string() + "/";
  kat::Drop second = ideal_drop(0.4);
  second.number = 2;
  kat::Drop failed;
  failed.number = 3;
  failed.fault = kat::Code::no_impact;
  failed.state = kat::State::beam_left;
  folder.write("a.log",
               "# my notes\n" + text_of(ideal_drop(0.2)) + text_of(second) + text_of(failed));
  const auto result =
      powderlink("kat device " + at + "a.log --csv " + at + "a.csv --study " + at +
                 "a.toml --particle 316L --substrate UPVC --critical-diameter 60 40 "
                 "--critical-diameter-sigma 1");
  ASSERT_EQ(result.status, 0) << result.err;
  EXPECT_NE(result.err.find("no_impact"), std::string::npos);
  const Study study = read_study(at + "a.toml");
  ASSERT_EQ(study.rows.size(), 2U);
  EXPECT_NEAR(study.rows[0].impact_velocity_m_s, std::sqrt(2 * kat::kGravity_m_s2 * 0.2), 2e-3);
  EXPECT_EQ(*study.rows[0].contact_time_us, 100.0);
  EXPECT_EQ(*study.rows[1].critical_diameter_um, 40.0);
  EXPECT_EQ(powderlink("compare " + at + "a.toml").status, 0);
  // Nothing is overwritten unless asked for.
  const std::string before = read_file(at + "a.csv");
  expect_four_parts(powderlink("kat device " + at + "a.log --csv " + at + "a.csv"), "--force");
  EXPECT_EQ(read_file(at + "a.csv"), before);
  EXPECT_EQ(powderlink("kat device " + at + "a.log --force --csv " + at + "a.csv").status, 0);
  expect_four_parts(powderlink("kat device " + at + "a.log --critical-diameter 60"),
                    "one per drop");
  expect_four_parts(powderlink("kat device " + at + "a.log --critical-diameter-sigma 1"),
                    "give --critical-diameter too");
}

/// The device reports by itself and again when asked, and a copy of a log may lie beside it.
TEST(KatDevice, ADropThatIsReportedTwiceIsOneDrop) {
  const TestFolder folder;
  const std::string at = folder.path().string() + "/";
  kat::Drop second = ideal_drop(0.4);  // of the same number: after the device was switched on again
  folder.write("a.log", text_of(ideal_drop(0.2)) + text_of(ideal_drop(0.2)));
  folder.write("b.log", text_of(second));
  folder.write("copy.log", text_of(ideal_drop(0.2)));
  const auto result = powderlink("kat device " + at + "./a.log '" + at + "*.log' --csv " + at +
                                 "a.csv --critical-diameter 60 40");
  ASSERT_EQ(result.status, 0) << result.err;
  EXPECT_EQ(read_csv(at + "a.csv").rows.size(), 2U);
  EXPECT_NE(result.err.find("a.log, line 12: the same report of drop 1 as "), std::string::npos)
      << result.err;
  EXPECT_NE(result.err.find("copy.log, line 6: the same report"), std::string::npos) << result.err;
}

TEST(KatDevice, MaterialsOfYourOwnGoIntoTheStudy) {
  const TestFolder folder;
  const std::string at = folder.path().string() + "/";
  folder.write("a.log", text_of(ideal_drop(0.2)));
  folder.write("p.toml", "density_kg_m3 = 4500\nyoungs_modulus_Pa = 1e11\npoissons_ratio = 0.3\n");
  const auto result = powderlink("kat device " + at + "a.log --study " + at + "s.toml --particle " +
                                 at + "p.toml --substrate structural_steel");
  ASSERT_EQ(result.status, 0) << result.err;
  const Study study = read_study(at + "s.toml");
  EXPECT_EQ(study.particle.density_kg_m3, 4500.0);
  EXPECT_EQ(study.substrate.name, "structural_steel");
}

TEST(KatDevice, NamesWithQuotesMakeAStudyThatCanBeRead) {
  const TestFolder folder;
  const std::string name = "a\"b\\\n[c]";  // of files: all of it is allowed
  folder.write(name + ".log", text_of(ideal_drop(0.2)));
  const auto file = [&](const char* suffix) {
    return " '" + (folder.path() / (name + suffix)).string() + "'";
  };
  const auto result =
      powderlink("kat device" + file(".log") + " --csv" + file(".csv") + " --study" +
                 file(".toml") + " --particle 316L --substrate UPVC --critical-diameter 60");
  ASSERT_EQ(result.status, 0) << result.err;
  const Study study = read_study(folder.path() / (name + ".toml"));
  EXPECT_EQ(study.name, name);
  EXPECT_EQ(study.rows.size(), 1U);
}

TEST(KatDevice, DamagedLogsAreNamed) {
  const TestFolder folder;
  const std::string at = folder.path().string() + "/";
  const std::string good = text_of(ideal_drop(0.2));
  std::string flipped = good;
  flipped[good.find("enter_us=") + 10] ^= 1;
  folder.write("flipped.log", flipped + good);
  folder.write("cut.log", good.substr(0, good.size() - 20));
  folder.write("short.log", good.substr(0, good.rfind("KAT1 end")));
  folder.write("empty.log", "");
  expect_four_parts(powderlink("kat device " + at + "flipped.log"),
                    "flipped.log, line 3: damaged line (bad_checksum)");
  expect_four_parts(powderlink("kat device " + at + "cut.log"), "cut.log, line 6");
  expect_four_parts(powderlink("kat device " + at + "short.log"), "without its end");
  expect_four_parts(powderlink("kat device " + at + "empty.log"), "no whole drop");
  expect_four_parts(powderlink("kat device " + at + "none.log"), "none.log");
  EXPECT_EQ(powderlink("kat device " + at + "flipped.log --skip-damaged").status, 0);
  expect_four_parts(powderlink("kat device"), "neither a port nor a log");
}

/// What terminals make of a good session.
TEST(KatDevice, AReportIsKnownByItsFieldsWhereverItStands) {
  const TestFolder folder;
  const std::string at = folder.path().string() + "/";
  const std::string good = text_of(ideal_drop(0.2));
  std::vector<std::string> lines;
  std::istringstream in(good);
  for (std::string line; std::getline(in, line);) lines.push_back(line);
  const auto message = [](kat::LineWriter line) { return std::string(line.finish()); };
  const std::string answer = message(kat::LineWriter("ok").text("cmd", "drop"));
  std::map<std::string, std::string> logs;
  logs["echo"] = "KAT1 arm*EC63\nKAT1 drop*FB12\n" + answer + good + "KAT1 report*F990\n" + good;
  for (std::size_t i = 0; i < lines.size(); ++i) {  // typed while the report comes
    logs["inside"] += lines[i] + "\n" + (i == 2 ? "KAT1 drop*FB12\nKAT1 status\n" : "");
    logs["times"] += "12:03:04." + std::to_string(i) + " -> " + lines[i] + "\n";
    logs["windows"] += "[2024-05-06T12:03:04Z] " + lines[i] + " \r\n";
    logs["one line"] += lines[i];
    logs["returns"] += lines[i] + "\r";
    logs["pairs"] += lines[i] + (i % 2 == 0 ? " | " : "\n");
  }
  logs["half a line"] = "er_us=4567 leave_us=9999*ABCD\n\x01\xfe" + good;
  logs["half a command"] = "KAT1 dr\b\bop*FB1\nKAT1 drop n=" + good;
  logs["comment"] = "# KAT1 beam n=1 enter_us=oops\nKATs and KAT1 are devices\n" + good;
  for (const auto& [name, text] : logs) {
    folder.write("a.log", text);
    const auto result = powderlink("kat device " + at + "a.log --force --csv " + at + "a.csv");
    EXPECT_EQ(result.status, 0) << name << ": " << result.err;
    ASSERT_EQ(read_csv(at + "a.csv").rows.size(), 1U) << name;
  }
  folder.write("a.log", logs["inside"]);
  const auto noted = powderlink("kat device " + at + "a.log");
  EXPECT_NE(noted.err.find("a.log, line 5: no message of the device (no_checksum): 'KAT1 status'"),
            std::string::npos)
      << noted.err;
  // What is lost stays lost, and is named as what it is.
  folder.write("late.log", good.substr(good.find("KAT1 beam")));
  expect_four_parts(powderlink("kat device " + at + "late.log"), "drop 1 without its beginning");
  EXPECT_EQ(powderlink("kat device --skip-damaged " + at + "late.log " + at + "a.log").status, 0);
  folder.write("missing.log", lines[0] + "\n" + lines[2] + "\n");
  expect_four_parts(powderlink("kat device " + at + "missing.log"), "line 2: broken report");
  folder.write("other.log", "KAT2 drop n=1*0000\n");
  const auto other = powderlink("kat device " + at + "other.log");
  expect_four_parts(other, "no whole drop");
  EXPECT_NE(other.err.find("line 1: no message of the device (bad_checksum)"), std::string::npos)
      << other.err;
  std::string wide = "\xff\xfe";
  for (const char c : good) wide += std::string(1, c) + '\0';
  folder.write("wide.log", wide);
  expect_four_parts(powderlink("kat device " + at + "wide.log"), "UTF-16");
  folder.write("unmarked.log", wide.substr(2));
  expect_four_parts(powderlink("kat device " + at + "unmarked.log"), "UTF-16");
}

TEST(KatDevice, DropsOverASerialPort) {
  const TestFolder folder;
  const std::string at = folder.path().string() + "/";
  kat::SimulatedDevice device;
  ASSERT_FALSE(device.port().empty());
  device.greeting = "\x01\xfe half a line";
  device.start();
  const std::string port = "kat device --wait 20 --port " + device.port();
  const auto result = powderlink(
      port +
      " --set carrier_um=10000 --do status --do config --do selftest --do arm --do drop --log " +
      at + "d.log --csv " + at + "d.csv");
  ASSERT_EQ(result.status, 0) << result.err << result.out;
  const auto again = powderlink("kat device " + at + "d.log");
  EXPECT_EQ(again.status, 0) << again.err;
  // The device still has the report, which is no second drop.
  EXPECT_EQ(powderlink(port + " --do report --do report --csv " + at + "r.csv").status, 0);
  EXPECT_EQ(read_csv(at + "r.csv").rows.size(), 1U);
  const CsvTable table = read_csv(at + "d.csv");
  EXPECT_NEAR(table.number(table.rows[0], 0) / device.board.scene.impact_velocity_m_s(), 1.0, 1e-3);
  EXPECT_NEAR(table.number(table.rows[0], *table.find_column("contact_time_us")), 100.0, 1.0);
  expect_four_parts(powderlink(port + " --set carrier_um=5"), "out_of_range");
  expect_four_parts(powderlink(port + " --set nonsense"), "KEY=VALUE");
  expect_four_parts(powderlink(port + " --do drop"), "wrong_state");
}

TEST(KatDevice, EveryCodeKeyAndStateIsInTheManual) {
  const std::string manual = read_file(POWDERLINK_MANUAL);
  const auto there = [&](const std::string& name) {
    EXPECT_NE(manual.find("| `" + name + "` |"), std::string::npos) << name;
  };
  for (uint8_t i = 1; i < static_cast<uint8_t>(kat::Code::count); ++i) {
    const auto code = static_cast<kat::Code>(i);
    there(kat::code_name(code));
    EXPECT_NE(manual.find(kat::code_advice(code)), std::string::npos) << kat::code_name(code);
  }
  for (uint8_t i = 0; i < kat::kConfigKeys; ++i) there(kat::config_key(i).name);
  for (uint8_t i = 0; i < static_cast<uint8_t>(kat::State::count); ++i)
    there(kat::state_name(static_cast<kat::State>(i)));
  for (const char* word :
       {"version", "status", "config", "selftest", "arm", "drop", "abort", "clear", "report"}) {
    kat::LineWriter line(word);
    EXPECT_NE(manual.find(line.finish()), std::string::npos) << word;
  }
}

TEST(KatDevice, ASilentOrMissingPortEnds) {
  const TestFolder folder;
  const std::string log = (folder.path() / "d.log").string();
  kat::SimulatedDevice device;
  device.silent = true;
  device.start();
  expect_four_parts(
      powderlink("kat device --wait 0.5 --do status --log " + log + " --port " + device.port()),
      "within 0.5 s");
  EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
  expect_four_parts(powderlink("kat device --do status --port /dev/no_such_port"), "no_such_port");
}

}  // namespace
}  // namespace powderlink::analysis
