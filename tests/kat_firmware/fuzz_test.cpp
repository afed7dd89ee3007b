// SPDX-License-Identifier: GPL-3.0-or-later
/// \file fuzz_test.cpp
/// Random event orders, bounces and disturbances with fixed seeds. Whatever the machine gets to see, it
/// must end in a report that is right or in a fault with a name, safe either way.
#include <gtest/gtest.h>

#include <random>

#include "kat_firmware/core/kat_machine.h"
#include "kat_firmware/core/kat_velocity.h"
#include "tests/kat_firmware/simulated_board.h"

namespace kat {
namespace {

using Edges = SimulatedBoard::Edges;

/// An oracle of its own: is this list of edges, in the order of time, one clean drop, and what is it?
struct Oracle {
  bool clean = false;
  uint32_t enter = 0, leave = 0, touch = 0;
};

Oracle judge(const Edges& edges) {
  Oracle o;
  std::vector<Edge> beam, contact;
  bool vibration = false;
  for (const Edge& e : edges) {
    const bool is_beam = e.kind == EdgeKind::beam_blocked || e.kind == EdgeKind::beam_clear;
    if (e.kind == EdgeKind::vibration) {
      if (beam.size() < 2) return o;
      vibration = true;
    } else if (is_beam) {
      if (contact.empty() && !vibration) beam.push_back(e);
    } else {
      if (beam.size() < 2) return o;
      const bool closes = e.kind == EdgeKind::contact_closed;
      if (closes != (contact.size() % 2 == 0)) return o;
      contact.push_back(e);
    }
  }
  if (beam.size() != 2 || beam[0].kind != EdgeKind::beam_blocked ||
      beam[1].kind != EdgeKind::beam_clear || contact.size() < 2 || !vibration)
    return o;
  o = {true, beam[0].time_us, beam[1].time_us, contact[0].time_us};
  return o;
}

struct Tally {
  int reports = 0, faults = 0;
};

void check(Machine& machine, const SimulatedBoard& board, const Edges& seen, Tally& tally) {
  const Drop& d = machine.last();
  ASSERT_TRUE(machine.state() == State::report || machine.state() == State::fault)
      << state_name(machine.state());
  ASSERT_FALSE(board.magnet || board.sensors);
  if (machine.state() == State::fault) {
    ++tally.faults;
    ASSERT_NE(d.fault, Code::none);
    ASSERT_EQ(d.velocity_um_s, static_cast<uint32_t>(kNoValue));
    return;
  }
  ++tally.reports;
  ASSERT_EQ(d.fault, Code::none);
  // Later edges than the end of the measurement are not part of it.
  Edges part;
  const Config& config = machine.config();
  uint32_t last = d.touch_us;
  bool closed = false;
  for (const Edge& e : seen) {
    const bool contact = e.kind == EdgeKind::contact_closed || e.kind == EdgeKind::contact_open;
    const uint32_t rest_us = closed ? config.contact_limit_us : config.quiet_us;
    if (e.time_us > last && e.time_us - last > rest_us) break;
    if (contact) {
      last = e.time_us;
      closed = e.kind == EdgeKind::contact_closed;
    }
    part.push_back(e);
  }
  const Oracle o = judge(part);
  ASSERT_TRUE(o.clean);
  ASSERT_EQ(d.enter_us, o.enter);
  ASSERT_EQ(d.leave_us, o.leave);
  ASSERT_EQ(d.touch_us, o.touch);
  // The law in floating point.
  const double h = machine.config().carrier_um * 1e-6, length = machine.config().beam_um * 1e-6;
  const double t = (o.leave - o.enter) * 1e-6;
  const double u = h / t - 0.5 * kGravity_m_s2 * t;
  const double v = std::sqrt(u * u + 2.0 * kGravity_m_s2 * length);
  ASSERT_NEAR(d.velocity_um_s * 1e-6, v, 1e-4 * v);
  // And the flight from the beam to the anvil tells the same within its tolerance.
  const double flight = 2.0 * (length - h) / (h / t + 0.5 * kGravity_m_s2 * t + v);
  ASSERT_NEAR((o.touch - o.leave) * 1e-6, flight,
              52e-6 + flight * machine.config().flight_permille * 1e-3);
}

Tally fuzz(unsigned seed, int rounds, const std::function<void(Edges&, std::mt19937&)>& disturb) {
  Tally tally;
  std::mt19937 random(seed);
  for (int i = 0; i < rounds; ++i) {
    SimulatedBoard board;
    Machine machine(board);
    board.clock_at_start = random();
    board.scene.height_m = 0.05 + 0.45 * (random() % 1000) * 1e-3;
    board.scene.contact_s = 5e-6 + (random() % 500) * 1e-6;
    board.scene.bounces = 1 + static_cast<int>(random() % 13);  // all fit into the ring
    board.scene.restitution = 0.05 + 0.6 * (random() % 1000) * 1e-3;
    Edges seen;
    board.disturb = [&](Edges& edges) {
      disturb(edges, random);
      std::stable_sort(edges.begin(), edges.end(),
                       [](const Edge& a, const Edge& b) { return a.time_us < b.time_us; });
      seen = edges;
    };
    EXPECT_EQ(machine.arm(), Code::none);
    board.run(machine, 250000, 10000);
    EXPECT_EQ(machine.drop(), Code::none);
    board.run(machine, 8000000, 1000 + random() % 4000);
    check(machine, board, seen, tally);
    if (::testing::Test::HasFatalFailure()) {
      ADD_FAILURE() << "seed " << seed << ", round " << i;
      return tally;
    }
  }
  return tally;
}

TEST(Fuzz, CleanDropsAreAllMeasured) {
  const Tally t = fuzz(1, 400, [](Edges&, std::mt19937&) {});
  EXPECT_EQ(t.reports, 400);
}

EdgeKind any_kind(std::mt19937& random) { return static_cast<EdgeKind>(random() % 5); }

TEST(Fuzz, OneEdgeMissed) {
  const Tally t = fuzz(2, 400, [](Edges& e, std::mt19937& random) {
    e.erase(e.begin() + static_cast<long>(random() % e.size()));
  });
  EXPECT_GT(t.faults, 200);
}

TEST(Fuzz, OneEdgeTooMany) {
  const Tally t = fuzz(3, 400, [](Edges& e, std::mt19937& random) {
    e.push_back({any_kind(random), static_cast<uint32_t>(random() % (e.back().time_us + 1000))});
  });
  EXPECT_GT(t.faults, 200);
}

TEST(Fuzz, OneEdgeAtAnotherTime) {
  const Tally t = fuzz(4, 400, [](Edges& e, std::mt19937& random) {
    e[random() % e.size()].time_us = static_cast<uint32_t>(random() % (e.back().time_us + 1000));
  });
  EXPECT_GT(t.faults, 100);
}

TEST(Fuzz, BurstsOfChatter) {
  const Tally t = fuzz(5, 300, [](Edges& e, std::mt19937& random) {
    const EdgeKind kind = any_kind(random);
    const uint32_t from = e[random() % e.size()].time_us;
    const uint32_t count = static_cast<uint32_t>(random() % 120);
    for (uint32_t i = 0; i < count; ++i) {
      const auto flipped = static_cast<EdgeKind>(static_cast<uint8_t>(kind) ^ (i % 2));
      e.push_back(
          {kind == EdgeKind::vibration ? kind : flipped, from + i * (1 + uint32_t(random() % 9))});
    }
  });
  EXPECT_GT(t.faults, 100);
}

TEST(Fuzz, NothingButNoise) {
  const Tally t = fuzz(6, 400, [](Edges& e, std::mt19937& random) {
    e.clear();
    const std::size_t count = random() % 60;
    for (std::size_t i = 0; i < count; ++i)
      e.push_back({any_kind(random), static_cast<uint32_t>(random() % 1500000)});
  });
  EXPECT_GE(t.faults, 390);  // chance may make a drop
}

std::string lines_of(const Drop& drop) {
  std::string text;
  for (uint8_t i = 0; i < drop.lines(); ++i) text += drop_line(drop, i).finish();
  return text;
}

/// Commands at random, in any state and with any world: the magnet never stays on outside `armed`, the
/// sensors never outside a test, what the last drop gave stays until the next is armed, and the machine
/// always comes back to idle.
TEST(Fuzz, CommandsInAnyOrder) {
  std::mt19937 random(7);
  for (int round = 0; round < 100; ++round) {
    SimulatedBoard board;
    Machine machine(board);
    board.clock_at_start = random();
    board.disturb = [&](Edges& e) {
      if (random() % 2 == 0) e.resize(random() % e.size());
    };
    for (int i = 0; i < 60; ++i) {
      const std::string before = lines_of(machine.last());
      bool ended = machine.state() != State::armed && !machine.measuring();
      switch (random() % 7) {
        case 0:
          if (machine.arm() == Code::none) ended = false;
          break;
        case 1:
          machine.drop();
          break;
        case 2:
          if (random() % 4 == 0) machine.abort();
          break;
        case 3:
          machine.clear();
          break;
        case 4:
          machine.self_test();
          break;
        case 5:
          machine.report_sent();
          break;
        default:
          machine.edge(any_kind(random), board.now_us());
      }
      board.closed = board.closed && random() % 2 == 0;
      board.blocked = board.blocked && random() % 2 == 0;
      board.run(machine, random() % 400000, 2000);
      const State state = machine.state();
      ASSERT_EQ(board.magnet, state == State::armed);
      ASSERT_EQ(board.sensors,
                state == State::armed || state == State::self_test || machine.measuring());
      ASSERT_TRUE(state != State::fault || machine.last().fault != Code::none);
      if (ended) ASSERT_EQ(lines_of(machine.last()), before) << "round " << round << ", turn " << i;
    }
    board.run(machine, 130000000, 20000);
    machine.clear();
    ASSERT_EQ(machine.state(), State::idle);
  }
}

}  // namespace
}  // namespace kat
