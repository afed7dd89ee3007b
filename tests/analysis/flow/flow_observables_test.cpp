// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/flow/observables/flow_observables.h"

#include <algorithm>
#include <boost/math/distributions/chi_squared.hpp>
#include <cmath>
#include <nlohmann/json.hpp>
#include <random>

#include "analysis/flow/flow_report.h"
#include "analysis/flow/observables/channel_bins.h"
#include "analysis/flow/observables/cluster_runs.h"
#include "analysis/flow/observables/counting_floor.h"
#include "analysis/flow/observables/elbow.h"
#include "analysis/flow/observables/momentum_account.h"
#include "analysis/flow/run/run_tables.h"
#include "tests/analysis/flow/flow_case.h"

namespace powderlink::analysis {
namespace {

const double kPi = std::acos(-1.0);

/// Flow of a Poisson stream of grains of random mass through a slice, averaged over a window, at
/// independent moments: the measured RMS over the mean.
double rms_of_poisson(double rate, double window, double variation, double transit,
                      std::mt19937& random, int moments) {
  std::exponential_distribution<double> wait(rate);
  std::gamma_distribution<double> mass(1.0 / (variation * variation), variation * variation);
  double sum = 0.0, squares = 0.0;
  for (int i = 0; i < moments; ++i) {
    // A grain that enters the slice at t counts 1/transit until t + transit.
    double flow = 0.0;
    for (double t = -transit + wait(random); t < window; t += wait(random)) {
      const double inside = std::min(t + transit, window) - std::max(t, 0.0);
      flow += mass(random) * inside / (transit * window);
    }
    sum += flow;
    squares += flow * flow;
  }
  const double mean = sum / moments;
  return std::sqrt(squares / moments - mean * mean) / mean;
}

TEST(CountingFloor, IsTheRmsOfAPoissonStream) {
  std::mt19937 random(11);
  constexpr int kMoments = 20000;
  // Four standard errors of an RMS of independent moments, 1/sqrt(2 n).
  const double error = 4.0 / std::sqrt(2.0 * kMoments);
  for (const double transit : {0.01, 0.3, 1.0, 2.5}) {  // in windows; beyond 1 they are exchanged
    const double found = rms_of_poisson(40.0, 1.0, 0.77, transit, random, kMoments);
    EXPECT_NEAR(found / counting_floor(40.0, 1.0, 0.77, transit), 1.0, error) << transit;
  }
  // Pipe A and B at a plane: 600 and 300 grains in 2 ms.
  EXPECT_NEAR(100.0 * counting_floor(3e5, 2e-3, 0.77, 0.0), 5.15, 0.01);
  EXPECT_NEAR(100.0 * counting_floor(1.5e5, 2e-3, 0.77, 0.0), 7.29, 0.01);
}

TEST(CountingFloor, IntervalHoldsTheTruthInNineteenOfTwenty) {
  std::mt19937 random(3);
  std::normal_distribution<double> value(0.0, 1.0);
  constexpr int kRecords = 4000, kWindows = 50;
  int held = 0;
  for (int i = 0; i < kRecords; ++i) {
    double sum = 0.0, squares = 0.0;
    for (int k = 0; k < kWindows; ++k) {
      const double x = value(random);
      sum += x;
      squares += x * x;
    }
    const double rms = std::sqrt((squares - sum * sum / kWindows) / (kWindows - 1));
    const auto interval = rms_interval(rms, 0.1, 2e-3);
    ASSERT_TRUE(interval);
    if (interval->from < 1.0 && interval->to > 1.0) ++held;
  }
  // Four standard errors of a share of 0.95.
  EXPECT_NEAR(held / static_cast<double>(kRecords), 0.95, 4.0 * std::sqrt(0.95 * 0.05 / kRecords));
  // Half its width is two relative standard errors 1/sqrt(2 K), to the order of 1/K.
  const auto interval = rms_interval(1.0, 1.0, 2e-3);
  EXPECT_NEAR(0.5 * (interval->to - interval->from), 1.96 / std::sqrt(2.0 * 500), 1e-3);
  EXPECT_FALSE(rms_interval(1.0, 5e-3, 2e-3));
}

TEST(FlowElbow, FindsTheBendExactlyAndWithinItsInterval) {
  const auto signal = [](double t) { return 3.0 + 40.0 * t - 36.0 * std::max(0.0, t - 0.07); };
  std::vector<double> times, exact;
  for (int i = 0; i <= 1500; ++i) {
    times.push_back(1e-4 * i);
    exact.push_back(signal(times.back()) + (i % 2 == 0 ? 1e-6 : -1e-6));
  }
  const auto found = find_elbow(times, exact);
  ASSERT_TRUE(found);
  EXPECT_NEAR(found->time, 0.07, 1e-6);
  EXPECT_NEAR(found->slope_before, 40.0, 1e-3);
  EXPECT_NEAR(found->slope_after, 4.0, 1e-3);
  EXPECT_NEAR(found->level, signal(0.07), 1e-4);
  // Correlated noise: 95 % of the intervals hold the truth, within four standard errors; the
  // likelihood is a profile with an estimated number of rows, so 0.03 more.
  std::mt19937 random(5);
  std::normal_distribution<double> kick(0.0, 0.2);
  constexpr int kRecords = 150;
  int held = 0;
  for (int record = 0; record < kRecords; ++record) {
    std::vector<double> noisy;
    double noise = 0.0;
    for (std::size_t i = 0; i < times.size(); i += 3) {
      noise = 0.6 * noise + kick(random);
      noisy.push_back(signal(times[i]) + noise);
    }
    std::vector<double> fewer;
    for (std::size_t i = 0; i < times.size(); i += 3) fewer.push_back(times[i]);
    const auto elbow = find_elbow(fewer, noisy);
    ASSERT_TRUE(elbow) << record;
    if (elbow->interval.from <= 0.07 && elbow->interval.to >= 0.07) ++held;
  }
  EXPECT_GE(held / static_cast<double>(kRecords), 0.95 - 4.0 * std::sqrt(0.05 / kRecords) - 0.03);
}

/// A pipe that fills slowly first: the elbow is where the slope falls, not where it grows, and the
/// bunches of a jammed flow, which swing for many rows, do not hide it.
TEST(FlowElbow, StopsToRiseAfterASlowStart) {
  constexpr double kStart = 0.02, kElbow = 0.05;
  const auto signal = [](double t) {
    return 1.7 + 10.0 * t + 40.0 * std::max(0.0, t - kStart) - 50.0 * std::max(0.0, t - kElbow);
  };
  std::mt19937 random(6);
  std::normal_distribution<double> kick(0.0, 1.0);
  constexpr double kStays = 0.9, kSwing = 0.06;  // from row to row; of a level of 3.4
  constexpr int kRecords = 100;
  int held = 0;
  for (int record = 0; record < kRecords; ++record) {
    std::vector<double> times, values;
    double swing = 0.0;
    for (int i = 0; i < 400; ++i) {
      swing = kStays * swing + std::sqrt(1.0 - kStays * kStays) * kick(random);
      times.push_back(5e-4 * i);
      values.push_back(signal(times.back()) + kSwing * swing);
    }
    const auto elbow = find_elbow(times, values);
    ASSERT_TRUE(elbow) << record;
    if (elbow->interval.from <= kElbow && elbow->interval.to >= kElbow) ++held;
  }
  // 95 %, within four standard errors of a share; as above, 0.03 more.
  EXPECT_GE(held / static_cast<double>(kRecords), 0.95 - 4.0 * std::sqrt(0.05 / kRecords) - 0.03);
  // Without swings both bends and the whole course come back.
  std::vector<double> times, values;
  for (int i = 0; i < 400; ++i) {
    times.push_back(5e-4 * i);
    values.push_back(signal(times.back()) + (i % 2 == 0 ? 1e-6 : -1e-6));
  }
  const auto exact = find_elbow(times, values);
  ASSERT_TRUE(exact);
  EXPECT_NEAR(exact->time, kElbow, 1e-6);
  EXPECT_NEAR(exact->slope_before, 50.0, 1e-3);
  EXPECT_NEAR(exact->slope_after, 0.0, 1e-3);
  for (const double t : {0.0, 0.01, 0.03, 0.07, 0.19}) EXPECT_NEAR(exact->at(t), signal(t), 1e-5);
}

TEST(FlowElbow, OneLineHasNone) {
  std::mt19937 random(8);
  std::normal_distribution<double> noise(0.0, 1.0);
  constexpr int kRecords = 200;
  int bent = 0;
  for (int record = 0; record < kRecords; ++record) {
    std::vector<double> times, values;
    for (int i = 0; i < 200; ++i) {
      times.push_back(i);
      values.push_back(0.1 * i + noise(random));
    }
    if (find_elbow(times, values)) ++bent;
  }
  // The F test's risk is 1 % at a known bend; the free bend multiplies it by some five.
  EXPECT_LE(bent, 0.1 * kRecords);
  EXPECT_FALSE(find_elbow({0, 1, 2}, {0, 1, 1}));
}

TEST(ClusterRuns, NumberByChanceIsThatOfAPoissonStream) {
  std::mt19937 random(4);
  std::poisson_distribution<int> grains(6.0);
  constexpr int kRecords = 4000, kSlices = 100;
  for (const std::size_t shortest : {1U, 2U, 3U}) {
    double runs = 0.0;
    for (int i = 0; i < kRecords; ++i) {
      std::vector<double> counts(kSlices);
      for (double& count : counts) count = grains(random);
      runs += static_cast<double>(cluster_runs(counts, 9.0, shortest).size());
    }
    const double expected = runs_by_chance(6.0, 9.0, shortest, kSlices);
    // Rare runs are nearly Poisson: four standard errors.
    EXPECT_NEAR(runs / kRecords, expected, 4.0 * std::sqrt(expected / kRecords)) << shortest;
  }
  const auto runs = cluster_runs({0, 3, 3, 0, 3, 3, 3}, 2.0, 2);
  ASSERT_EQ(runs.size(), 2U);
  EXPECT_EQ(runs[0].first, 1U);
  EXPECT_EQ(runs[1].end, 7U);
}

/// Uniform acceleration: v^2 = v_0^2 + 2 a s. What a part takes up is m a per grain.
TEST(MomentumAccount, ClosesForAcceleratedGrains) {
  constexpr double kStart_m_s = 2.0, kAcceleration_m_s2 = 50.0, kMass_kg = 1e-9, kStep_s = 5e-4;
  constexpr double kGap_s = 1e-4;  // between grains
  MomentumAccount account(FlowAxis{}, {0.1, 0.2});
  double force_impulse = 0.0;
  for (int n = 0; n <= 40; ++n) {
    const double time_s = 0.2 + kStep_s * n;
    DumpState state;
    for (int i = 0; i < 3000; ++i) {
      const double age_s = time_s - kGap_s * i;
      if (age_s < 0.0) break;
      DumpParticle p;
      p.id = i + 1;
      p.z_m = kStart_m_s * age_s + 0.5 * kAcceleration_m_s2 * age_s * age_s;
      p.vz_m_s = kStart_m_s + kAcceleration_m_s2 * age_s;
      p.mass_kg = kMass_kg;
      p.radius_m = 3e-5;
      if (p.z_m < 0.3) state.particles.push_back(p);
    }
    account.add(time_s, state);
  }
  // Time of a grain in the part: from its speeds at both ends, (v_2 - v_1)/a; a stream of 1/gap.
  const auto speed = [&](double s) {
    return std::sqrt(kStart_m_s * kStart_m_s + 2.0 * kAcceleration_m_s2 * s);
  };
  const double inside = (speed(0.2) - speed(0.1)) / kAcceleration_m_s2 / kGap_s;
  const double duration_s = account.last_s() - account.first_s();
  force_impulse = inside * kMass_kg * kAcceleration_m_s2 * duration_s;
  const double taken = account.last_kg_m_s() - account.first_kg_m_s() - account.entered_kg_m_s() +
                       account.left_kg_m_s();
  // A grain in or out at either end of the record: 1 of 200 that pass. Linear in place instead of
  // in time: (a dt)^2/(8 v^2) of a crossing grain's v, below 1e-5.
  EXPECT_NEAR(taken / force_impulse, 1.0, 1.0 / 200.0);
  EXPECT_NEAR(account.left_kg_m_s(), kMass_kg * speed(0.2) * duration_s / kGap_s,
              1.01 * kMass_kg * speed(0.2));
  EXPECT_NEAR(account.mean_mass_kg(), inside * kMass_kg, 0.51 * kMass_kg);
}

TEST(MomentumAccount, GrainsThatAppearVanishOrTurnBack) {
  MomentumAccount account(FlowAxis{}, {0.0, 1.0});
  const auto grain = [](long id, double z, double v) {
    DumpParticle p;
    p.id = id, p.z_m = z, p.vz_m_s = v, p.mass_kg = 1.0, p.radius_m = 0.1;
    return p;
  };
  account.add(0.0, {0, {}, {grain(1, 0.1, -1.0), grain(2, 0.5, 3.0), grain(4, 1.2, -2.0)}});
  // 1 leaves backwards at v = -1.5 (half of the way), 2 vanishes, 3 appears, 4 comes in from behind.
  account.add(1.0, {1, {}, {grain(1, -0.1, -2.0), grain(3, 0.5, 7.0), grain(4, 0.8, -2.0)}});
  EXPECT_NEAR(account.left_kg_m_s(), -1.5 + 3.0, 1e-12);
  EXPECT_NEAR(account.entered_kg_m_s(), 7.0 - 2.0, 1e-12);
  EXPECT_NEAR(account.first_kg_m_s(), 2.0, 1e-12);
  EXPECT_NEAR(account.last_kg_m_s(), 5.0, 1e-12);
  EXPECT_NEAR(account.longest_step(), 0.4, 1e-12);
  // The same id with another mass is another grain.
  DumpParticle other = grain(3, 0.6, 1.0);
  other.mass_kg = 2.0;
  account.add(2.0, {2, {}, {grain(1, -0.2, -2.0), other, grain(4, 0.5, -2.0)}});
  EXPECT_NEAR(account.left_kg_m_s(), 1.5 + 7.0, 1e-12);
  EXPECT_NEAR(account.entered_kg_m_s(), 5.0 + 2.0, 1e-12);
}

TEST(RunTables, LaterPartsWinAndDamageIsRefused) {
  const TestFolder folder;
  write_in(folder, "postProcessing/f/0/surfaceFieldValue.dat",
           "# Area : 2.5e-6\n# Time v\n0.1 (1 2 3)\n0.2 (4 5 6)\n0.3 (7 8");
  write_in(folder, "postProcessing/f/0.2/surfaceFieldValue.dat", "# Time v\n0.2 (40 50 60)\n");
  write_in(folder, "postProcessing/f/0.2/surfaceFieldValue_0.2.dat", "0.4 (1 1 1)\n");
  const RunTable table = read_function_object(folder.path(), "f", "surfaceFieldValue");
  EXPECT_EQ(table.rows.size(), 3U);
  EXPECT_EQ(table.rows.at(0.2)[1], 50.0);
  EXPECT_EQ(table.head_number("Area"), 2.5e-6);
  EXPECT_EQ(table.mean(0, 0.1, 0.2), 40.0);
  EXPECT_FALSE(table.mean(0, 0.4, 0.5));
  EXPECT_TRUE(read_function_object(folder.path(), "none", "surfaceFieldValue").rows.empty());
  write_in(folder, "postProcessing/f/0/surfaceFieldValue.dat",
           "0.1 (1 2 3)\n0.2 (4 5)\n0.3 (1 2 3)\n");
  expect_refusal([&] { read_function_object(folder.path(), "f", "surfaceFieldValue"); },
                 {"line 2"});

  const std::string title = "time_s,escaped,escaped_kg\n";
  write_in(folder, "post/particle_count.csv",
           title + "1,1,10\n2,2,20\n3,3,30\n" + title + "2,2,21\n3,4,31\n4,5");
  const auto counts = read_counts(folder.path());
  EXPECT_EQ(counts.at("time_s"), (std::vector<double>{1, 2, 3}));
  EXPECT_EQ(counts.at("escaped_kg"), (std::vector<double>{10, 21, 31}));
  write_in(folder, "post/particle_count.csv", title + "1,x,2\n2,1,1\n");
  expect_refusal([&] { read_counts(folder.path()); }, {"line 2", "1,x,2"});
  write_in(folder, "post/particle_count.csv", "1,2\n2,1\n");
  expect_refusal([&] { read_counts(folder.path()); }, {"no title"});

  write_in(folder, "post/powder_forces_0.txt",
           "# head\n# Timestep Number-of-bins\n# Bin Coord Ncount v_wallForce v_fluidForce\n"
           "250 2\n  1 0.5 10 -1e-9 3e-9\n  2 1.5 0 0 0\n500 2\n  1 0.5");
  write_in(folder, "post/powder_forces_250.txt",
           "# Bin Coord Ncount v_wallForce v_fluidForce\n"
           "500 2\n  1 0.5 20 -1e-9 3e-9\n  2 1.5 1 0 5e-9\n");
  const auto forces = read_powder_forces(folder.path());
  ASSERT_EQ(forces.size(), 2U);
  EXPECT_EQ(forces[1].step, 500);
  EXPECT_NEAR(forces[1].wall_N[0], -2e-8, 1e-20);
  EXPECT_NEAR(forces[1].fluid_N[1], 5e-9, 1e-20);
  write_in(folder, "post/powder_forces_0.txt",
           "# Bin Coord Ncount v_wallForce\n250 1\n1 0.5 1 1\n9 9\n");
  expect_refusal([&] { read_powder_forces(folder.path()); }, {"v_fluidForce"});
}

double number_in(const FlowReport& report, const std::string& key) {
  const auto json = nlohmann::json::parse(flow_json(report));
  const auto& found = json.at(key);
  return found.is_object() ? found.at("value").get<double>() : found.get<double>();
}

const std::string& table_in(const std::vector<std::pair<std::string, std::string>>& tables,
                            const std::string& name) {
  return std::find_if(tables.begin(), tables.end(),
                      [&](const auto& table) { return table.first == name; })
      ->second;
}

/// Grains spread evenly over a round section, faster in the middle; three states.
TEST(FlowObservables, ProfilesOfAnEvenSection) {
  constexpr double kRadius_m = 6e-4, kFastest_m_s = 8.0;
  constexpr int kGrains = 60000;
  const TestFolder folder;
  std::mt19937 random(9);
  std::uniform_real_distribution<double> any(0.0, 1.0);
  std::vector<DumpParticle> particles;
  for (int i = 0; i < kGrains; ++i) {
    const double r = kRadius_m * std::sqrt(any(random)), angle = 2.0 * kPi * any(random);
    DumpParticle p;
    p.id = i + 1;
    p.x_m = r * std::cos(angle), p.y_m = r * std::sin(angle), p.z_m = any(random);
    p.vz_m_s = kFastest_m_s * (1.0 - r * r / (kRadius_m * kRadius_m));
    p.radius_m = 3e-5, p.mass_kg = 1e-9;
    particles.push_back(p);
  }
  write_in(folder, "post/particles_0.dump", dump_text(0, particles));
  FlowOptions options;
  options.time_step_s = 1e-6;
  options.from_m = 0.0;
  options.slice_m = 0.01;
  const auto tables = flow_tables(analyse_flow(folder.path(), options));
  std::istringstream text(table_in(tables, "section_radius.csv"));
  std::string line;
  std::getline(text, line);
  double counted = 0.0;
  // Without a mesh the section is as wide as the outermost grain: radius more than its centre.
  const double wide = kRadius_m + 3e-5;
  while (std::getline(text, line)) {
    double r = 0.0, count = 0.0, share = 0.0, mean = 0.0;
    const int read = std::sscanf(line.c_str(), "%lf,%lf,%lf,%lf", &r, &count, &share, &mean);
    ASSERT_EQ(read, count > 0 ? 4 : 3) << line;
    counted += count;
    const double edge = r + 0.5 * wide / 25.0;
    if (edge > kRadius_m || count == 0.0) continue;
    const double even = 1.0 / (kPi * kRadius_m * kRadius_m);
    EXPECT_NEAR(share / even, 1.0, 4.0 / std::sqrt(count)) << line;
    // Mean of the parabola over the ring; its scatter within a ring of width d is below v' d.
    const double inner = r - 0.5 * wide / 25.0;
    const double ring =
        kFastest_m_s * (1.0 - 0.5 * (edge * edge + inner * inner) / (kRadius_m * kRadius_m));
    EXPECT_NEAR(mean, ring, 4.0 * 2.0 * kFastest_m_s * (wide / 25.0) / kRadius_m / std::sqrt(count))
        << line;
  }
  EXPECT_EQ(counted, kGrains);
  // A chord's length over the area: share per height at the middle is 2/(pi R).
  std::istringstream heights(table_in(tables, "section_height.csv"));
  std::getline(heights, line);
  for (int i = 0; i < 25; ++i) {
    std::getline(heights, line);
    double y = 0.0, count = 0.0, share = 0.0;
    std::sscanf(line.c_str(), "%lf,%lf,%lf", &y, &count, &share);
    if (i != 12) continue;
    EXPECT_NEAR(y, 0.0, 1e-12);
    // The chord is shorter by (d/2R)^2/6 within the bin, below 1e-3.
    EXPECT_NEAR(share * kPi * kRadius_m / 2.0, 1.0, 4.0 / std::sqrt(count) + 1e-3);
  }
}

/// Grains fly at 10 m/s, fall to 2 m/s between 0.4 and 0.5 of the channel: v(s) linear there.
TEST(FlowObservables, FrontIsHalfWay) {
  for (const int way : {1, -1}) {
    const TestFolder folder;
    std::vector<DumpParticle> particles;
    constexpr int kGrains = 20000;
    for (int i = 0; i < kGrains; ++i) {
      const double s = (i + 0.5) / kGrains;
      DumpParticle p;
      p.id = i + 1;
      p.z_m = way > 0 ? s : 1.0 - s;
      p.vz_m_s = way * (s < 0.4 ? 10.0 : s > 0.5 ? 2.0 : 10.0 - 80.0 * (s - 0.4));
      p.radius_m = 3e-5, p.mass_kg = 1e-9;
      p.y_m = 1e-4 * (i % 3 - 1);
      particles.push_back(p);
    }
    write_in(folder, "post/particles_0.dump", dump_text(0, particles));
    FlowOptions options;
    options.time_step_s = 1e-6;
    options.axis = way > 0 ? "z" : "-z";
    const FlowReport report = analyse_flow(folder.path(), options);
    // v falls to 6 m/s at s = 0.45; a bin of 0.01 averages the corners at 0.4 and 0.5 only.
    EXPECT_NEAR(number_in(report, "front_m"), way > 0 ? 0.45 : 0.55, 1e-4);
    const std::string envelope = table_in(flow_tables(report), "envelope.csv");
    EXPECT_NE(envelope.find("0.995,200,-0.0001,0.0001"), std::string::npos) << envelope;
  }
  const TestFolder folder;
  write_in(folder, "post/particles_0.dump", dump_text(0, stream_at(0)));
  FlowOptions options;
  options.time_step_s = 1e-6;
  EXPECT_NE(flow_json(analyse_flow(folder.path(), options)).find("\"front_m\": null"),
            std::string::npos);
}

/// Every tenth centimetre is twice as full, and slower.
TEST(FlowObservables, ClustersOfAConstructedStream) {
  const TestFolder folder;
  std::vector<DumpParticle> particles;
  const auto put = [&](double z, double v) {
    DumpParticle p;
    p.id = static_cast<long>(particles.size()) + 1;
    p.z_m = z, p.vz_m_s = v, p.radius_m = 3e-5, p.mass_kg = 1e-9;
    particles.push_back(p);
  };
  for (int mm = 0; mm < 1000; ++mm) {
    const bool dense = mm % 100 < 10;
    for (int i = 0; i < (dense ? 44 : 10); ++i) {
      put(1e-3 * (mm + (i + 0.5) / 44.0), dense ? 2.0 : 4.0);
    }
  }
  write_in(folder, "post/particles_0.dump", dump_text(0, particles));
  FlowOptions options;
  options.time_step_s = 1e-6;
  options.from_m = 0.0;
  const FlowReport report = analyse_flow(folder.path(), options);
  EXPECT_NEAR(number_in(report, "cluster_count"), 10.0, 1e-12);
  EXPECT_NEAR(number_in(report, "cluster_length_m"), 0.01, 1e-12);
  EXPECT_NEAR(number_in(report, "cluster_velocity_m_s"), 2.0, 1e-12);
  EXPECT_NEAR(number_in(report, "cluster_mass_percent"), 100.0 * 4400 / 13400, 1e-9);
  EXPECT_NEAR(number_in(report, "cluster_velocity_over_mean"),
              2.0 * 13400 / (2.0 * 4400 + 4.0 * 9000), 1e-12);
  options.measures.cluster_threshold = 1.0;
  expect_refusal([&] { analyse_flow(folder.path(), options); }, {"--cluster-threshold"});
  options.measures.cluster_threshold = 1.5;
  options.measures.cluster_length_m = 0.0;
  expect_refusal([&] { analyse_flow(folder.path(), options); }, {"--cluster-length"});
}

/// Counts of a Poisson stream: its mean, its floor.
TEST(FlowObservables, OutletOfAPoissonStream) {
  constexpr double kRate_1_s = 3e5, kMass_kg = 1e-9, kSpan_s = 0.4;
  const TestFolder folder;
  std::mt19937 random(21);
  std::poisson_distribution<int> grains(kRate_1_s * 1e-4);
  std::string counts = "time_s,escaped,escaped_kg\n";
  long escaped = 0;
  for (int i = 0; i <= std::lround(kSpan_s / 1e-4); ++i) {
    counts += fmt::format("{:.6g},{},{:.9g}\n", 1e-4 * i, escaped,
                          kMass_kg * static_cast<double>(escaped));
    escaped += grains(random);
  }
  write_in(folder, "post/particle_count.csv", counts);
  write_in(folder, "post/particles_0.dump", dump_text(0, stream_at(0)));
  FlowOptions options;
  options.time_step_s = 1e-6;
  const FlowReport report = analyse_flow(folder.path(), options);
  const auto json = nlohmann::json::parse(flow_json(report));
  const auto& mean = json.at("outlet_flow_kg_s");
  const double truth = kRate_1_s * kMass_kg;
  EXPECT_NEAR(mean.at("value").get<double>(), truth, 4.0 * truth / std::sqrt(kRate_1_s * kSpan_s));
  const auto& rms = json.at("outlet_flow_rms_percent");
  const double floor = number_in(report, "outlet_flow_rms_floor_percent");
  EXPECT_NEAR(floor, 100.0 / std::sqrt(kRate_1_s * 2e-3), 0.01 * floor);
  // Four standard errors of 200 windows.
  EXPECT_NEAR(rms.at("value").get<double>() / floor, 1.0, 4.0 / std::sqrt(2.0 * 200));
  EXPECT_LT(rms.at("low").get<double>(), rms.at("value").get<double>());
  EXPECT_GT(rms.at("high").get<double>(), rms.at("value").get<double>());
}

/// A stroke at the start and swings of every layer hide neither elbow nor slopes.
TEST(FlowObservables, ElbowOfTheInletPressure) {
  constexpr double kGas_kg_m3 = 2.0;
  const TestFolder folder;
  std::mt19937 random(2);
  std::normal_distribution<double> swing(0.0, 20.0);
  std::string rows = "# Time areaAverage(p)\n";
  for (int i = 1; i <= 1500; ++i) {
    const double t = 1e-4 * i;
    const double p = t < 0.07 ? 3e4 * t : 2100.0 + 2e3 * (t - 0.07);
    rows += fmt::format("{:.6g} {:.9g}\n", t, p + swing(random) + (i < 4 ? 8e4 : 0.0));
  }
  write_in(folder, "postProcessing/inletPressure/0/surfaceFieldValue.dat", rows);
  write_in(folder, "postProcessing/axis/0/p",
           "# Probe 0 (0 0 0.1)\n# Probe 1 (0 0 0.2)\n0.1 2 1\n");
  write_in(folder, "post/particles_0.dump", dump_text(0, stream_at(0)));
  FlowOptions options;
  options.time_step_s = 1e-6;
  options.density_kg_m3 = kGas_kg_m3;
  const FlowReport report = analyse_flow(folder.path(), options);
  const auto elbow = nlohmann::json::parse(flow_json(report)).at("inlet_pressure_elbow_s");
  const double low = elbow.at("low").get<double>(), high = elbow.at("high").get<double>();
  // Four standard errors, of which the interval is about four wide. Swings of 20 over slopes that
  // differ by 2.8e4, on 1500 rows, make some 5e-5 s; a median's error is 1.25 times a mean's.
  EXPECT_NEAR(elbow.at("value").get<double>(), 0.07, high - low);
  EXPECT_LT(high - low, 4e-4);
  EXPECT_NEAR(number_in(report, "inlet_pressure_slope_before_Pa_s") / (kGas_kg_m3 * 3e4), 1.0,
              0.01);
}

/// All of a balance is constructed: each term comes back, and what is left open.
TEST(FlowObservables, BalanceOfConstructedForces) {
  constexpr double kArea_m2 = 1e-6, kGas_kg_m3 = 2.0;
  const TestFolder folder;
  // p = 1000 (1 - z) m^2/s^2 kinematic: 2000 Pa/m, so 1000 Pa over 0.2 to 0.7 m: 1e-3 N.
  write_in(folder, "postProcessing/axis/0/p",
           "# Probe 0 (0 0 0.1)\n# Probe 1 (0 0 0.4)\n# Probe 2 (0 0 0.9)\n"
           "1e-3 900 600 100\n2e-3 900 600 100\n");
  write_in(folder, "postProcessing/balanceEnds/0/U",
           "# Probe 0 (0 0 0.2)\n# Probe 1 (0 0 0.7)\n# Time\n1e-3 (0 0 1) (0 0 1)\n");
  for (const auto& [name, value] : {std::pair("In", 1e-5), std::pair("Out", 2e-5)}) {
    write_in(
        folder, fmt::format("postProcessing/balance{}flow/0/surfaceFieldValue.dat", name),
        fmt::format("# Area : {:g}\n# Time x\n1e-3 {:g}\n2e-3 {:g}\n", kArea_m2, value, value));
  }
  // Ten bins over 0 to 1 m, which hold face centres of 0.05 to 0.95 m; 1e-4 N in each.
  std::string bins = "# bins : 10\n# start : 0.05\n# end : 0.95\n1e-3", row;
  for (int i = 0; i < 10; ++i) row += " (0 0 1e-4) (0 0 0) (0 0 1e-4)";
  write_in(folder, "postProcessing/wallForce/0/forceBin.dat", bins + row + "\n2e-3" + row + "\n");
  std::string forces = "# Bin Coord Ncount v_wallForce v_fluidForce\n";
  for (const int step : {1000, 2000}) {
    forces += fmt::format("{} 10\n", step);
    for (int i = 0; i < 10; ++i)
      forces += fmt::format("{} {:g} 100 -2e-7 9e-7\n", i + 1, 0.05 + 0.1 * i);
  }
  write_in(folder, "post/powder_forces_0.txt", forces);
  // Grains of 1e-9 kg at 3 m/s everywhere: no momentum is taken up; a new one per 1e-3 m.
  for (const int step : {0, 1000, 2000}) {
    std::vector<DumpParticle> particles;
    for (int i = -10; i < 1000; ++i) {
      DumpParticle p;
      p.id = i + 100;
      p.z_m = 1e-3 * (i + 0.5) + 3.0 * 1e-6 * step;
      p.vz_m_s = 3.0, p.radius_m = 3e-5, p.mass_kg = 1e-9;
      if (p.z_m > 0.0 && p.z_m < 1.0) particles.push_back(p);
    }
    write_in(folder, fmt::format("post/particles_{}.dump", step), dump_text(step, particles));
  }
  FlowOptions options;
  options.time_step_s = 1e-6;
  options.density_kg_m3 = kGas_kg_m3;
  const FlowReport report = analyse_flow(folder.path(), options);
  const auto force = [&](const char* key) {
    return number_in(report, fmt::format("force_balance_{}_N", key));
  };
  constexpr double kDigits = 1e-9;
  EXPECT_NEAR(force("pressure_drop"), 1e-3, kDigits * 1e-3);
  // The mesh is not there: the bins count from the first to the last face centre, 0.09 m each.
  EXPECT_NEAR(force("gas_wall"), 1e-4 * 0.5 / 0.09, kDigits);
  EXPECT_NEAR(force("gas_on_powder"), 5 * 9e-5, kDigits);
  EXPECT_NEAR(force("gas_momentum"), kGas_kg_m3 * 1e-5, kDigits);
  EXPECT_NEAR(force("gas_rest"), 1e-3 - 1e-4 * 0.5 / 0.09 - 4.5e-4 - 2e-5, kDigits);
  EXPECT_NEAR(force("powder_friction"), -5 * 2e-5, kDigits);
  EXPECT_NEAR(force("powder_momentum"), 0.0, kDigits);
  EXPECT_NEAR(force("powder_rest"), 4.5e-4 - 1e-4, kDigits);
  EXPECT_NEAR(number_in(report, "force_balance_powder_open_percent"), 100.0 * 3.5 / 4.5, 1e-6);
  EXPECT_NE(table_in(flow_tables(report), "force_balance.csv").find("gas,wall shear,"),
            std::string::npos);
}

}  // namespace
}  // namespace powderlink::analysis
