// SPDX-License-Identifier: GPL-3.0-or-later
/// \file machine_test.cpp
/// The test against free fall, every state, limit and fault, at several moments of the 32-bit clock.
#include "kat_firmware/core/kat_machine.h"

#include <gtest/gtest.h>

#include <set>

#include "kat_firmware/core/kat_velocity.h"
#include "tests/kat_firmware/simulated_board.h"

namespace kat {
namespace {

constexpr uint64_t kWarm_us = 300000;
constexpr double kVelocityTolerance = 1e-3;  // demanded of the device

Code configure(Machine& machine, const char* key, uint32_t value) {
  LineWriter writer("set");
  writer.number(key, value);
  const char* text = writer.finish();
  Line line;
  EXPECT_EQ(line.parse(text, static_cast<uint16_t>(writer.length() - 1)), Code::none);
  return machine.configure(line);
}

struct Bench {
  SimulatedBoard board;
  Machine machine{board};

  void set_geometry() {
    const auto um = [](double m) { return static_cast<uint32_t>(std::lround(m * 1e6)); };
    // In the order that keeps the beam above the carrier.
    EXPECT_EQ(configure(machine, "carrier_um", 1000), Code::none);
    EXPECT_EQ(configure(machine, "beam_um", um(board.scene.beam_m)), Code::none);
    EXPECT_EQ(configure(machine, "carrier_um", um(board.scene.carrier_m)), Code::none);
  }
  void release() {
    ASSERT_EQ(machine.arm(), Code::none);
    board.run(machine, kWarm_us);
    ASSERT_EQ(machine.drop(), Code::none);
  }
  const Drop& test() {
    release();
    board.run(machine, 3000000);
    return machine.last();
  }
  bool safe() const {
    return !board.magnet && !board.sensors && !machine.magnet_on() && !machine.sensors_on();
  }
  void expect_fault(Code fault, State state) {
    EXPECT_EQ(machine.state(), State::fault);
    EXPECT_STREQ(code_name(machine.last().fault), code_name(fault));
    EXPECT_STREQ(state_name(machine.last().state), state_name(state));
    EXPECT_EQ(machine.last().velocity_um_s, static_cast<uint32_t>(kNoValue));
    EXPECT_TRUE(safe());
  }
};

TEST(Machine, MeasuresFreeFallFrom10To500Millimetres) {
  for (int mm = 10; mm <= 500; mm += 10) {
    Bench b;
    b.board.scene.height_m = mm * 1e-3;
    b.board.scene.beam_m = std::min(0.03, 0.8 * b.board.scene.height_m);
    b.board.scene.carrier_m = mm < 30 ? 0.005 : 0.01;
    b.set_geometry();
    const Drop& d = b.test();
    ASSERT_EQ(b.machine.state(), State::report) << mm << " mm: " << code_name(d.fault);
    EXPECT_NEAR(d.velocity_um_s * 1e-6 / b.board.scene.impact_velocity_m_s(), 1.0,
                kVelocityTolerance)
        << mm << " mm";
    EXPECT_TRUE(b.safe());
  }
}

/// To the microsecond of the clock, whatever the turn of the loop.
TEST(Machine, ContactTimesAreThoseOfTheEdges) {
  for (const double contact_s : {20e-6, 50e-6, 100e-6, 200e-6, 5e-3}) {
    for (const uint64_t step_us : {50ULL, 700ULL, 5000ULL}) {
      Bench b;
      b.board.scene.contact_s = contact_s;
      b.release();
      b.board.run(b.machine, 3000000, step_us);
      const Drop& d = b.machine.last();
      ASSERT_EQ(b.machine.state(), State::report) << code_name(d.fault);
      ASSERT_EQ(d.contacts.kept(), b.board.scene.bounces + 1);
      for (int i = 0; i < b.board.scene.bounces; ++i) {
        EXPECT_NEAR(d.contacts[static_cast<uint8_t>(i)].duration_us, contact_s * 1e6, 1.0);
      }
      EXPECT_EQ(d.contacts.finished() + 1U, d.contacts.total());  // it rests, closed
      EXPECT_EQ(d.vibration_us - d.touch_us, 66U);
    }
  }
}

TEST(Machine, WalksThroughEveryState) {
  Bench b;
  std::set<State> seen;
  b.board.run(b.machine, 1000, 100, [&] { seen.insert(b.machine.state()); });
  ASSERT_EQ(b.machine.arm(), Code::none);
  EXPECT_TRUE(b.board.magnet && b.board.sensors);
  b.board.run(b.machine, kWarm_us, 100, [&] { seen.insert(b.machine.state()); });
  ASSERT_EQ(b.machine.drop(), Code::none);
  EXPECT_TRUE(!b.board.magnet && b.board.sensors);
  b.board.run(b.machine, 1000000, 20, [&] { seen.insert(b.machine.state()); });
  for (const State state : {State::idle, State::armed, State::released, State::beam_entered,
                            State::beam_left, State::impact, State::contact_ended, State::report}) {
    EXPECT_TRUE(seen.count(state)) << state_name(state);
  }
  b.machine.report_sent();
  EXPECT_EQ(b.machine.state(), State::idle);
  b.machine.report_sent();  // of no effect twice
  EXPECT_EQ(b.machine.state(), State::idle);
  EXPECT_EQ(b.machine.last().number, 1U);
}

TEST(Machine, ReportsOpenContactWhenTheCarrierComesToRestApart) {
  Bench b;
  b.board.disturb = [](SimulatedBoard::Edges& edges) { edges.pop_back(); };  // the last closing
  const Drop& d = b.test();
  ASSERT_EQ(b.machine.state(), State::report);
  EXPECT_EQ(d.contacts.finished(), d.contacts.total());
}

TEST(Machine, AReportThatNobodyFetchesEnds) {
  Bench b;
  b.test();
  ASSERT_EQ(b.machine.state(), State::report);
  b.board.run(b.machine, b.machine.config().report_limit_us);
  EXPECT_EQ(b.machine.state(), State::idle);
  EXPECT_EQ(b.machine.last().fault, Code::none);
}

TEST(Machine, ASecondDropForgetsTheFirst) {
  Bench b;
  b.board.switches_mV = 18000;
  b.board.peak_mg = 5000;
  b.test();
  EXPECT_EQ(b.machine.last().switches, 3U);
  EXPECT_EQ(b.machine.last().peak_mg, 5000U);
  b.machine.report_sent();
  b.board.closed = false;
  b.board.switches_mV = 5000;
  b.board.peak_mg = kNoValue;
  b.test();
  EXPECT_EQ(b.machine.last().number, 2U);
  EXPECT_EQ(b.machine.last().switches, static_cast<uint32_t>(kNoValue));
  EXPECT_EQ(b.machine.last().peak_mg, static_cast<uint32_t>(kNoValue));
  EXPECT_EQ(b.machine.last().contacts.total(), 4U);
}

TEST(Machine, TheLargestOfSwitchesAndAccelerationIsKept) {
  Bench b;
  b.release();
  const uint32_t switches_mV[] = {12000, 16000, 12000}, peaks_mg[] = {100, 900, 100};
  std::size_t turn = 0;
  b.board.run(b.machine, 1000000, 500, [&] {
    if (b.machine.state() < State::impact || turn == 3) return;
    b.board.switches_mV = switches_mV[turn];
    b.board.peak_mg = peaks_mg[turn++];
  });
  EXPECT_EQ(b.machine.last().switches, 2U);
  EXPECT_EQ(b.machine.last().peak_mg, 900U);
}

TEST(Machine, RefusesWhatIsOutOfTurnAndChangesNothing) {
  Bench b;
  EXPECT_EQ(b.machine.drop(), Code::wrong_state);
  EXPECT_EQ(b.machine.abort(), Code::wrong_state);
  EXPECT_EQ(b.machine.clear(), Code::wrong_state);
  EXPECT_TRUE(b.safe());
  ASSERT_EQ(b.machine.arm(), Code::none);
  EXPECT_EQ(b.machine.arm(), Code::wrong_state);
  EXPECT_EQ(b.machine.self_test(), Code::wrong_state);
  EXPECT_EQ(b.machine.drop(), Code::warming_up);
  EXPECT_EQ(configure(b.machine, "carrier_um", 5000), Code::wrong_state);
  b.board.run(b.machine, kWarm_us);
  b.board.blocked = true;
  EXPECT_EQ(b.machine.drop(), Code::beam_blocked);
  b.board.blocked = false;
  b.board.closed = true;
  EXPECT_EQ(b.machine.drop(), Code::contact_closed);
  EXPECT_EQ(b.machine.state(), State::armed);
  EXPECT_TRUE(b.board.magnet);  // the sample is not lost
  b.board.closed = false;
  EXPECT_EQ(b.machine.drop(), Code::none);
}

TEST(Machine, AbortIsSafeEverywhere) {
  Bench b;
  ASSERT_EQ(b.machine.arm(), Code::none);
  EXPECT_EQ(b.machine.abort(), Code::none);
  EXPECT_EQ(b.machine.state(), State::idle);
  EXPECT_TRUE(b.safe());
  ASSERT_EQ(b.machine.self_test(), Code::none);
  EXPECT_EQ(b.machine.abort(), Code::none);
  EXPECT_TRUE(b.safe());
  b.release();
  EXPECT_EQ(b.machine.abort(), Code::none);
  b.expect_fault(Code::aborted, State::released);
  EXPECT_EQ(b.machine.arm(), Code::wrong_state);
  EXPECT_EQ(b.machine.clear(), Code::none);
  EXPECT_EQ(b.machine.state(), State::idle);
}

/// The report may still be fetched: it must not be called aborted.
TEST(Machine, AbortingASelfTestLeavesTheLastDropAsItWas) {
  Bench b;
  ASSERT_EQ(b.test().fault, Code::none);
  b.machine.report_sent();
  const uint32_t velocity_um_s = b.machine.last().velocity_um_s;
  ASSERT_EQ(b.machine.self_test(), Code::none);
  ASSERT_EQ(b.machine.abort(), Code::none);
  EXPECT_STREQ(code_name(b.machine.last().fault), "none");
  EXPECT_EQ(b.machine.last().velocity_um_s, velocity_um_s);
  // Of the next drop, armed and not let go, nothing was measured.
  b.board.closed = false;
  ASSERT_EQ(b.machine.arm(), Code::none);
  ASSERT_EQ(b.machine.abort(), Code::none);
  EXPECT_EQ(b.machine.last().number, 2U);
  EXPECT_STREQ(code_name(b.machine.last().fault), "aborted");
}

TEST(Machine, SelfTestReadsTheSensorsAndPowersThemOff) {
  Bench b;
  const auto result = [&](bool blocked, bool closed) {
    b.board.blocked = blocked;
    b.board.closed = closed;
    EXPECT_EQ(b.machine.self_test(), Code::none);
    EXPECT_EQ(b.machine.state(), State::self_test);
    EXPECT_TRUE(b.board.sensors && !b.board.magnet);
    b.board.run(b.machine, kWarm_us);
    EXPECT_EQ(b.machine.state(), State::idle);
    EXPECT_TRUE(b.safe());
    return b.machine.self_test_result();
  };
  EXPECT_EQ(result(false, false), Code::none);
  EXPECT_EQ(result(true, false), Code::beam_blocked);
  EXPECT_EQ(result(false, true), Code::contact_closed);
  EXPECT_EQ(b.machine.self_tests(), 3U);
}

TEST(Machine, EdgesOutsideATestAreNotKept) {
  Bench b;
  for (int i = 0; i < 100; ++i) b.machine.edge(EdgeKind::contact_closed, 0);
  EXPECT_EQ(b.test().fault, Code::none);
  for (int i = 0; i < 100; ++i) b.machine.edge(EdgeKind::contact_closed, 0);
  b.board.run(b.machine, 1000);
  EXPECT_EQ(b.machine.state(), State::report);
}

// Every limit, by a world in which the next thing does not happen.

using Edges = SimulatedBoard::Edges;

void remove_from(Edges& edges, EdgeKind first) {
  for (std::size_t i = 0; i < edges.size(); ++i) {
    if (edges[i].kind == first) edges.resize(i);
  }
}
void remove_kind(Edges& edges, EdgeKind kind) {
  edges.erase(
      std::remove_if(edges.begin(), edges.end(), [&](const Edge& e) { return e.kind == kind; }),
      edges.end());
}

struct FaultCase {
  const char* name;
  Code fault;
  State state;
  std::function<void(Edges&)> disturb;
};

const std::vector<FaultCase>& fault_cases() {
  static const std::vector<FaultCase> cases = {
      {"nothing happens", Code::no_beam_entry, State::released, [](Edges& e) { e.clear(); }},
      {"beam stuck", Code::no_beam_exit, State::beam_entered, [](Edges& e) { e.resize(1); }},
      {"jammed below the beam", Code::no_impact, State::beam_left, [](Edges& e) { e.resize(2); }},
      {"contact broken", Code::no_contact, State::impact,
       [](Edges& e) { remove_from(e, EdgeKind::contact_closed); }},
      {"vibration switch broken", Code::no_vibration, State::impact,
       [](Edges& e) { remove_kind(e, EdgeKind::vibration); }},
      {"vibration switch broken, at rest apart", Code::no_vibration, State::contact_ended,
       [](Edges& e) {
         e.pop_back();
         remove_kind(e, EdgeKind::vibration);
       }},
      {"contact stuck", Code::contact_stuck, State::impact,
       [](Edges& e) { remove_from(e, EdgeKind::contact_open); }},
      {"entry missed", Code::beam_out_of_order, State::released,
       [](Edges& e) { e.erase(e.begin()); }},
      {"entry doubled", Code::beam_out_of_order, State::beam_entered,
       [](Edges& e) {
         e.push_back({EdgeKind::beam_blocked, e[0].time_us + 100});
       }},
      {"beam chatters behind the carrier", Code::beam_out_of_order, State::beam_left,
       [](Edges& e) {
         e.push_back({EdgeKind::beam_blocked, e[1].time_us + 10});
       }},
      {"exit doubled", Code::beam_out_of_order, State::beam_left,
       [](Edges& e) {
         e.push_back({EdgeKind::beam_clear, e[1].time_us + 10});
       }},
      {"contact before the beam", Code::early_impact, State::released,
       [](Edges& e) {
         e.push_back({EdgeKind::contact_closed, e[0].time_us - 100});
       }},
      {"vibration before the beam", Code::early_impact, State::released,
       [](Edges& e) {
         e.push_back({EdgeKind::vibration, e[0].time_us - 100});
       }},
      {"contact in the beam", Code::early_impact, State::beam_entered,
       [](Edges& e) {
         e.push_back({EdgeKind::contact_closed, e[0].time_us + 100});
       }},
      {"vibration in the beam", Code::early_impact, State::beam_entered,
       [](Edges& e) {
         e.push_back({EdgeKind::vibration, e[0].time_us + 100});
       }},
      {"contact opens first", Code::contact_out_of_order, State::beam_left,
       [](Edges& e) {
         e.push_back({EdgeKind::contact_open, e[1].time_us + 100});
       }},
      {"opening missed", Code::contact_stuck, State::impact,
       [](Edges& e) { e.erase(e.begin() + 4); }},
      {"closing doubled", Code::contact_out_of_order, State::impact,
       [](Edges& e) {
         e.push_back({EdgeKind::contact_closed, e[3].time_us + 50});
       }},
      {"impact too soon", Code::times_inconsistent, State::impact,
       [](Edges& e) {
         for (std::size_t i = 2; i < e.size(); ++i) e[i].time_us -= 4000;
       }},
      {"impact too late", Code::times_inconsistent, State::impact,
       [](Edges& e) {
         for (std::size_t i = 2; i < e.size(); ++i) e[i].time_us += 4000;
       }},
      {"slower than from rest", Code::times_inconsistent, State::impact,
       [](Edges& e) {
         for (std::size_t i = 1; i < e.size(); ++i) e[i].time_us += 100000;
       }},
      {"bounces without end", Code::no_rest, State::contact_ended,
       [](Edges& e) {
         e.pop_back();
         for (uint32_t t = e.back().time_us + 900; t < 7000000; t += 1000) {
           e.push_back({EdgeKind::contact_closed, t});
           e.push_back({EdgeKind::contact_open, t + 100});
         }
       }},
      {"bounces without end, mostly closed", Code::no_rest, State::impact,
       [](Edges& e) {
         e.pop_back();
         for (uint32_t t = e.back().time_us + 900; t < 7000000; t += 1000) {
           e.push_back({EdgeKind::contact_closed, t});
           e.push_back({EdgeKind::contact_open, t + 990});
         }
       }},
      {"chatter faster than the loop", Code::event_overflow, State::beam_left,
       [](Edges& e) {
         for (uint32_t i = 0; i < 400; ++i) {
           e.push_back({i % 2 == 0 ? EdgeKind::contact_closed : EdgeKind::contact_open,
                        e[1].time_us + 1000 + i});
         }
       }},
  };
  return cases;
}

TEST(Machine, EveryFailureHasItsNameAndIsSafe) {
  for (const FaultCase& c : fault_cases()) {
    SCOPED_TRACE(c.name);
    Bench b;
    b.board.disturb = c.disturb;
    b.release();
    b.board.run(b.machine, 8000000);
    b.expect_fault(c.fault, c.state);
    // The next test is as if nothing had been.
    b.board.disturb = [](Edges&) {};
    b.board.blocked = b.board.closed = false;
    ASSERT_EQ(b.machine.clear(), Code::none);
    EXPECT_EQ(b.test().fault, Code::none);
    EXPECT_EQ(b.machine.state(), State::report);
  }
}

TEST(Machine, TheMagnetIsNotLeftOn) {
  Bench b;
  ASSERT_EQ(b.machine.arm(), Code::none);
  b.board.run(b.machine, b.machine.config().arm_limit_us - 1000, 100000);
  EXPECT_EQ(b.machine.state(), State::armed);
  b.board.run(b.machine, 2000);
  b.expect_fault(Code::arm_timeout, State::armed);
}

TEST(Machine, ARestLongAfterAnotherBounceIsOne) {
  Bench b;  // the vibration switch is not used, and a second sign of it is of no matter
  ASSERT_EQ(configure(b.machine, "vibration", 0), Code::none);
  b.board.disturb = [](Edges& e) { remove_kind(e, EdgeKind::vibration); };
  EXPECT_EQ(b.test().fault, Code::none);
  EXPECT_EQ(b.machine.state(), State::report);
}

TEST(Machine, VibrationMayComeFirstAndMoreThanOnce) {
  Bench b;
  b.board.disturb = [](Edges& e) {
    e[2].time_us -= 70;  // 4 us before the touch
    e.push_back({EdgeKind::vibration, e[3].time_us + 500});
    // Bouncing through the beam is no fault.
    e.push_back({EdgeKind::beam_blocked, e[3].time_us + 20000});
    e.push_back({EdgeKind::beam_clear, e[3].time_us + 30000});
  };
  const Drop& d = b.test();
  ASSERT_EQ(b.machine.state(), State::report) << code_name(d.fault);
  EXPECT_EQ(d.touch_us - d.vibration_us, 4U);
}

/// A limit is judged by the time of the edge, not by when the loop came to it.
TEST(Machine, ASlowLoopNeitherMissesNorInventsATimeout) {
  Bench b;
  const uint64_t late_us = 4000000;
  b.board.scene.height_m = 0.1;
  b.release();
  b.board.run(b.machine, late_us, late_us);  // one turn for the whole drop
  EXPECT_EQ(b.machine.state(), State::report) << code_name(b.machine.last().fault);
  Bench late;
  late.board.disturb = [](Edges& e) {
    for (std::size_t i = 0; i < e.size(); ++i) e[i].time_us += 1100000;
  };
  late.release();
  late.board.run(late.machine, late_us, late_us);
  late.expect_fault(Code::no_beam_entry, State::released);
}

TEST(Machine, AnEdgeOlderThanTheReleaseIsNoTimeout) {
  Bench b;
  b.release();
  b.machine.edge(EdgeKind::beam_blocked, b.board.now_us() - 3);
  b.machine.poll();
  EXPECT_EQ(b.machine.state(), State::beam_entered);
}

/// An interrupt between reading the clock and the ring: its edge is later than `now`.
TEST(Machine, AnInterruptWithinPollIsHandledInOrder) {
  Bench b;
  b.release();
  bool once = true;
  b.board.on_clock = [&](uint32_t now) {
    if (once) b.machine.edge(EdgeKind::beam_blocked, now + 2);
    once = false;
  };
  b.machine.poll();
  EXPECT_EQ(b.machine.state(), State::beam_entered);
  EXPECT_EQ(b.machine.last().fault, Code::none);
}

/// Loss of an edge is never hidden by what was measured before it.
TEST(Machine, AnOverflowInTheLastTurnIsNotAReport) {
  Bench b;
  b.board.disturb = [](Edges& e) {
    const uint32_t last = e.back().time_us;
    for (uint32_t i = 0; i < 40; ++i) e.push_back({EdgeKind::vibration, last + 500000 + i});
  };
  b.release();
  b.board.run(b.machine, 4000000, 4000000);
  b.expect_fault(Code::event_overflow, State::released);
}

// The clock passes 2^32 in every stage: the results are those of any other moment.

TEST(Machine, TheClocksEndInAnyStageChangesNothing) {
  Bench reference;
  const Drop expected = reference.test();
  // From arm to rest: 0.3 s warming up, 0.2 s fall, then bounces; 2 s in all.
  for (uint32_t before_us = 0; before_us <= 1200000;
       before_us += before_us < 480000 || before_us > 530000 ? 7001 : 97) {
    Bench b;
    b.board.clock_at_start = 0U - before_us;
    const Drop& d = b.test();
    ASSERT_EQ(b.machine.state(), State::report) << before_us << " " << code_name(d.fault);
    ASSERT_EQ(d.velocity_um_s, expected.velocity_um_s) << before_us;
    ASSERT_EQ(d.contacts.total(), expected.contacts.total());
    for (uint8_t i = 0; i < d.contacts.kept(); ++i) {
      ASSERT_EQ(d.contacts[i].start_us, expected.contacts[i].start_us);
      ASSERT_EQ(d.contacts[i].duration_us, expected.contacts[i].duration_us);
    }
  }
}

TEST(Machine, TheClocksEndInAnyFaultChangesNothing) {
  for (const FaultCase& c : fault_cases()) {
    SCOPED_TRACE(c.name);
    for (const uint32_t before_us :
         {300001U, 350000U, 480000U, 500000U, 502000U, 700000U, 1300000U, 4000000U}) {
      Bench b;
      b.board.clock_at_start = 0U - before_us;
      b.board.disturb = c.disturb;
      b.release();
      b.board.run(b.machine, 8000000, 2000);
      ASSERT_STREQ(code_name(b.machine.last().fault), code_name(c.fault)) << before_us;
      ASSERT_TRUE(b.safe());
    }
  }
}

TEST(Machine, TheClocksEndWhileArmedTestingOrReporting) {
  for (const uint32_t before_us : {1U, 1000U, 60000000U, 119999000U}) {
    Bench b;
    b.board.clock_at_start = 0U - before_us;
    ASSERT_EQ(b.machine.arm(), Code::none);
    b.board.run(b.machine, 119000000, 100000);
    ASSERT_EQ(b.machine.state(), State::armed);
    b.board.run(b.machine, 2000000, 100000);
    b.expect_fault(Code::arm_timeout, State::armed);
  }
  Bench b;
  b.board.clock_at_start = 0U - 100000;
  ASSERT_EQ(b.machine.self_test(), Code::none);
  b.board.run(b.machine, 190000);
  EXPECT_EQ(b.machine.state(), State::self_test);
  b.board.run(b.machine, 20000);
  EXPECT_EQ(b.machine.state(), State::idle);
  Bench report;
  report.board.clock_at_start = 0U - 5000000;
  report.test();
  report.board.run(report.machine, 5000000);
  EXPECT_EQ(report.machine.state(), State::report);
  report.board.run(report.machine, 10000000);
  EXPECT_EQ(report.machine.state(), State::idle);
}

}  // namespace
}  // namespace kat
