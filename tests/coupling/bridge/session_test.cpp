// SPDX-License-Identifier: GPL-3.0-or-later
// What two programs must agree on before they exchange anything.
#include "coupling/bridge/transport/session.h"

#include <cmath>
#include <functional>
#include <thread>

#include <gtest/gtest.h>

#include "tests/coupling/bridge/fails.h"
#include "tests/coupling/bridge/memory_transport.h"

namespace powderlink::test {
namespace {

using bridge::BridgeError;
using bridge::FieldSpec;
using bridge::Hello;
using bridge::Session;
using Kind = BridgeError::Kind;

const FieldSpec velocity{"velocity", "m/s", bridge::vector3, bridge::ElementType::float64};
const FieldSpec force{"force", "N", bridge::vector3, bridge::ElementType::float64};

Hello dem() { return {"dem", "pipe", 1, 1e-5, {velocity}, {force}}; }
Hello solver() { return {"solver", "pipe", 2, 1e-5, {force}, {velocity}}; }

struct Outcome {
  Kind kind = Kind::bad_input;
  std::string text;
};

Outcome open(std::unique_ptr<bridge::Transport> transport, const Hello& hello) {
  try {
    Session session(std::move(transport), hello, 5.0);
    session.finish();
    return {};
  } catch (const BridgeError& e) {
    return {e.kind(), e.what()};
  }
}

std::pair<Outcome, Outcome> shake_hands(const Hello& one, const Hello& other) {
  auto ends = bridge::memory_transport_pair();
  Outcome second;
  std::thread thread([&] { second = open(std::move(ends.second), other); });
  const Outcome first = open(std::move(ends.first), one);
  thread.join();
  return {first, second};
}

void expect_same_error(const Hello& one, const Hello& other, const std::string& words) {
  const auto [first, second] = shake_hands(one, other);
  EXPECT_EQ(first.kind, Kind::mismatch) << first.text;
  EXPECT_EQ(second.kind, Kind::mismatch) << second.text;
  EXPECT_EQ(first.text, second.text);
  EXPECT_NE(first.text.find(words), std::string::npos) << first.text;
}

TEST(Session, ProgramsThatFitShakeHands) {
  const auto [first, second] = shake_hands(dem(), solver());
  EXPECT_EQ("", first.text);
  EXPECT_EQ("", second.text);
}

TEST(Session, HelloSurvivesTheWay) {
  Hello hello = dem();
  hello.case_name = "pipe \"A\"\n\xff";
  hello.clock = {0.1, true, -0.25};
  const Hello back = bridge::hello_from_text(bridge::to_text(hello));
  EXPECT_EQ(back.role, hello.role);
  EXPECT_EQ(back.ranks, 1);
  EXPECT_EQ(back.exchange_interval_s, 1e-5);
  EXPECT_EQ(back.clock.time_s, 0.1);
  EXPECT_TRUE(back.clock.continues);
  EXPECT_EQ(back.clock.ahead_s, -0.25);
  EXPECT_EQ(back.offers, hello.offers);
  EXPECT_EQ(back.needs, hello.needs);
}

TEST(Session, BothSidesGetTheSameError) {
  Hello other = solver();
  other.role = "dem";
  expect_same_error(dem(), other, "both programs are 'dem'");
  other = solver();
  other.case_name = "bed";
  expect_same_error(dem(), other, "dem runs 'pipe', solver runs 'bed'");
  other = solver();
  other.exchange_interval_s = 2e-5;
  expect_same_error(dem(), other, "dem: 1e-05 s, solver: 2e-05 s");
  other = solver();
  other.needs = {{"velocty", "m/s", bridge::vector3, bridge::ElementType::float64}};
  expect_same_error(dem(), other, "fields of dem: velocity [m/s] float64 3x1");
  other = solver();
  other.needs[0].unit = "mm/s";
  expect_same_error(dem(), other, "solver needs velocity [mm/s]");
  other = solver();
  other.offers[0].shape = bridge::scalar;
  expect_same_error(dem(), other, "solver offers force [N] float64 1x1");
  other = solver();
  other.offers[0].type = bridge::ElementType::int32;
  expect_same_error(dem(), other, "int32");
}

TEST(Session, AnIntervalOfZeroTakesThatOfTheOtherSide) {
  Hello other = solver();
  other.exchange_interval_s = 0.0;
  EXPECT_EQ("", shake_hands(dem(), other).first.text);
}

/// Exchanges every 1e-5 s; the particles' clock was 0.25 s ahead of the fluid's.
TEST(Session, CheckpointsOfDifferentMomentsAreRefused) {
  const auto clocks = [](bridge::Clock particles, bridge::Clock fluid) {
    Hello one = dem(), other = solver();
    one.clock = particles;
    other.clock = fluid;
    return std::make_pair(one, other);
  };
  const auto good = [&](bridge::Clock particles, bridge::Clock fluid) {
    const auto [one, other] = clocks(particles, fluid);
    EXPECT_EQ("", shake_hands(one, other).first.text);
  };
  const auto bad = [&](bridge::Clock particles, bridge::Clock fluid, const char* words) {
    const auto [one, other] = clocks(particles, fluid);
    expect_same_error(one, other, words);
  };
  good({0.25, false, 0.0}, {0.0, false, 0.0});  // a new run, with a bed that has settled before
  good({0.35, true, 0.25}, {0.1, true, -0.25});
  good({0.35, false, 0.0}, {0.1, true, -0.25});  // a restart file that does not know of the run
  good({0.35, true, 0.25}, {0.1 + 1e-7, true, -0.25});  // six digits
  bad({0.35, true, 0.25}, {0.1 + 1e-5, true, -0.25}, "solver starts at 0.10001 s");
  bad({0.35, true, 0.25}, {0.0, false, 0.0},
      "dem goes on from its checkpoint of 0.35 s, solver starts at 0 s");
  bad({0.0, false, 0.0}, {0.1, true, -0.25}, "solver goes on from its checkpoint of 0.1 s");
}

TEST(Session, OwnMistakesAreNamedBeforeTheHandshake) {
  const auto refused = [](const std::function<void(Hello&)>& spoil, const std::string& words) {
    Hello hello = dem();
    spoil(hello);
    auto ends = bridge::memory_transport_pair();
    EXPECT_EQ("", failure_of([&] { Session s(std::move(ends.first), hello, 1.0); }, Kind::bad_input,
                             words));
  };
  refused([](Hello& h) { h.role.clear(); }, "role");
  refused([](Hello& h) { h.case_name.clear(); }, "case name");
  refused([](Hello& h) { h.ranks = 0; }, "ranks");
  refused([](Hello& h) { h.exchange_interval_s = -1.0; }, "interval");
  refused([](Hello& h) { h.clock.time_s = std::nan(""); }, "clock");
  refused([](Hello& h) { h.offers.push_back(velocity); }, "twice");
  refused([](Hello& h) { h.needs[0].unit.clear(); }, "unit");
}

TEST(Session, ASilentPeerEndsAtTheTimeout) {
  auto ends = bridge::memory_transport_pair();
  EXPECT_EQ("", failure_of([&] { Session s(std::move(ends.first), dem(), 0.1); }, Kind::timeout,
                           "nothing within 0.1 s"));
}

TEST(Session, TextOfThePeerCannotSteerATerminal) {
  auto ends = bridge::memory_transport_pair();
  bridge::Bytes frame;
  bridge::encode_text(frame, bridge::MessageKind::error, "a\033[2Jb");
  ends.second->send(frame, bridge::Deadline(1.0));
  EXPECT_EQ("", failure_of([&] { Session s(std::move(ends.first), dem(), 1.0); }, Kind::peer_failed,
                           "a [2Jb"));
}

TEST(Session, ThePeerThatFinishedFirstIsNamed) {
  auto ends = bridge::memory_transport_pair();
  std::thread peer([&] {
    Session session(std::move(ends.second), solver(), 5.0);
    session.finish();
  });
  Session session(std::move(ends.first), dem(), 5.0);
  EXPECT_EQ("", failure_of([&] { session.receive_frame(); }, Kind::peer_lost, "finished"));
  session.finish();
  peer.join();
}

}  // namespace
}  // namespace powderlink::test
