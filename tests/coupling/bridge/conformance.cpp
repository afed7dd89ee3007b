// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/coupling/bridge/conformance.h"

#include <cmath>
#include <thread>

#include "coupling/bridge/transport/session.h"
#include "tests/coupling/bridge/fails.h"
#include "tests/coupling/bridge/sample_frames.h"

namespace powderlink::test {
namespace {

using bridge::BridgeError;
using bridge::Bytes;
using bridge::Deadline;
using bridge::Hello;
using bridge::Session;
using Kind = BridgeError::Kind;
using TransportPtr = std::unique_ptr<bridge::Transport>;

constexpr double patience_s = 10.0;

double seconds(Deadline::Clock::time_point since) {
  return std::chrono::duration<double>(Deadline::Clock::now() - since).count();
}

bool same(const Bytes& a, const Bytes& b) {
  return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size()) == 0;
}

Bytes frame_of(std::uint64_t seed, std::size_t most_rows) {
  Generator random(seed);
  Bytes frame;
  encode(frame, random_fields(random, most_rows), static_cast<std::int64_t>(seed));
  return frame;
}

/// 8 MB: more than any transport holds on its way.
Bytes large_frame(std::uint64_t seed) {
  Generator random(seed);
  bridge::Field field({"large", "1", bridge::scalar, bridge::ElementType::int64});
  field.resize(1000000);
  for (auto& value : field.values<std::int64_t>()) value = static_cast<std::int64_t>(random());
  Bytes frame;
  encode(frame, {field}, static_cast<std::int64_t>(seed));
  return frame;
}

void send(bridge::Transport& to, Bytes frame) { to.send(frame, Deadline(patience_s)); }

Bytes receive(bridge::Transport& from) {
  Bytes frame;
  from.receive(frame, Deadline(patience_s));
  return frame;
}

void expect_lost(bridge::Transport& transport) {
  const auto start = Deadline::Clock::now();
  require_none(failure_of([&] { receive(transport); }, Kind::peer_lost, "connection to"));
  require(seconds(start) < 2.0, "the end of the peer was noticed late");
}

// Frames of many sizes come back as they were.
void echo_first(TransportPtr transport) {
  require(!transport->peer().empty(), "no name of the peer");
  Bytes back;
  for (std::uint64_t i = 0; i < 200; ++i) {
    const Bytes frame = frame_of(i, i);
    send(*transport, frame);
    transport->receive(back, Deadline(patience_s));
    require(same(frame, back), "an echo differs");
  }
  expect_lost(*transport);
}
void echo_second(TransportPtr transport) {
  Bytes frame;
  for (int i = 0; i < 200; ++i) {
    transport->receive(frame, Deadline(patience_s));
    transport->send(frame, Deadline(patience_s));
  }
}

// Many frames one way keep their order.
void order_first(TransportPtr transport) {
  for (std::uint64_t i = 0; i < 300; ++i) send(*transport, frame_of(i, 50));
  receive(*transport);
}
void order_second(TransportPtr transport) {
  std::this_thread::sleep_for(std::chrono::milliseconds(50));
  for (std::uint64_t i = 0; i < 300; ++i) {
    require(same(receive(*transport), frame_of(i, 50)), "frames are out of order");
  }
  send(*transport, frame_of(0, 0));
  expect_lost(*transport);
}

// Both send more than the line holds before either reads.
void crossing(TransportPtr transport, std::uint64_t mine, std::uint64_t theirs) {
  for (std::uint64_t i = 0; i < 3; ++i) send(*transport, large_frame(mine + i));
  for (std::uint64_t i = 0; i < 3; ++i) {
    require(same(receive(*transport), large_frame(theirs + i)), "a large frame differs");
  }
}
void crossing_first(TransportPtr transport) { crossing(std::move(transport), 10, 20); }
void crossing_second(TransportPtr transport) { crossing(std::move(transport), 20, 10); }

// A slow peer: the timeout is honoured within 20 %.
void slow_first(TransportPtr transport) {
  for (const double timeout_s : {0.3, 1.0}) {
    const auto start = Deadline::Clock::now();
    Bytes frame;
    require_none(failure_of([&] { transport->receive(frame, Deadline(timeout_s)); }, Kind::timeout,
                            "waiting for"));
    const double waited_s = seconds(start);
    require(std::abs(waited_s - timeout_s) < 0.2 * timeout_s,
            "waited " + std::to_string(waited_s) + " s of " + std::to_string(timeout_s));
  }
  transport->close();
}
void slow_second(TransportPtr transport) {
  require_none(failure_of([&] { receive(*transport); }, Kind::peer_lost, "connection to"));
}

// A peer that closes: what it sent is read first, then the end is noticed at once.
void close_first(TransportPtr transport) {
  send(*transport, frame_of(1, 10));
  transport->close();
  transport->close();
  require_none(failure_of([&] { send(*transport, frame_of(1, 1)); }, Kind::peer_lost, ""));
}
void close_second(TransportPtr transport) {
  require(same(receive(*transport), frame_of(1, 10)), "the last frame was lost");
  expect_lost(*transport);
}

// Writing to a peer that has gone.
void deaf_first(TransportPtr transport) {
  const auto start = Deadline::Clock::now();
  const std::string failure = failure_of(
      [&] {
        while (seconds(start) < 5.0) send(*transport, large_frame(1));
      },
      Kind::peer_lost, "connection to");
  require_none(failure);
  require(seconds(start) < 2.0, "the end of the peer was noticed late");
}
void deaf_second(TransportPtr transport) {
  std::this_thread::sleep_for(std::chrono::milliseconds(100));
  transport->close();
}

// A damaged frame is found by the reader; both sides get an error that says so.
void damage_first(TransportPtr transport) {
  Bytes hello;
  bridge::encode_text(hello, bridge::MessageKind::hello,
                      R"({"role":"dem","case":"pipe","ranks":1,"exchange_interval_s":0,)"
                      R"("time_s":0,"continues":false,"ahead_s":0,)"
                      R"("offers":[],"needs":[]})");
  send(*transport, hello);
  receive(*transport);
  Bytes frame = frame_of(3, 20);
  frame[frame.size() - 1] ^= std::byte{0x10};
  send(*transport, frame);
  bridge::FrameView view;
  const Bytes answer = receive(*transport);
  bridge::decode(answer, view);
  require(view.kind == bridge::MessageKind::error, "the reader did not complain");
  require(view.text.find("checksum") != std::string_view::npos, "the reason was not told");
}
void damage_second(TransportPtr transport) {
  Hello hello;
  hello.role = "solver";
  hello.case_name = "pipe";
  Session session(std::move(transport), hello, patience_s);
  require_none(failure_of([&] { session.receive_frame(); }, Kind::bad_frame, "checksum"));
}

Hello hello_of(const std::string& role) {
  const bridge::FieldSpec velocity{"velocity", "m/s", bridge::vector3,
                                   bridge::ElementType::float64};
  const bridge::FieldSpec force{"force", "N", bridge::vector3, bridge::ElementType::float64};
  const bool dem = role == "dem";
  return {role, "pipe", dem ? 1 : 2, 1e-5, {dem ? velocity : force}, {dem ? force : velocity}};
}

void send_field(Session& session, std::int64_t step, const bridge::FieldSpec& spec,
                const std::vector<double>& values) {
  Bytes frame;
  bridge::FrameWriter writer(frame);
  writer.begin(bridge::MessageKind::fields, step, 1e-5 * double(step));
  writer.add(spec, bridge::ColumnView(values.data(), values.size() / 3));
  writer.finish();
  session.send_frame(frame);
}

// A whole run: handshake, exchanges, goodbye.
void run_first(TransportPtr transport) {
  Session session(std::move(transport), hello_of("dem"), patience_s);
  require(session.peer().role == "solver" && session.peer().ranks == 2, "wrong hello");
  std::vector<double> velocity(300);
  for (int step = 0; step < 20; ++step) {
    for (std::size_t i = 0; i < velocity.size(); ++i) velocity[i] = step + 0.5 * double(i);
    send_field(session, step, session.mine().offers[0], velocity);
    const bridge::FrameView& answer = session.receive_frame();
    require(answer.step == step, "wrong step");
    const auto force = answer.find("force")->values<double>();
    for (std::size_t i = 0; i < force.size(); ++i) {
      require(force[i] == 2.0 * velocity[i], "wrong value");
    }
  }
  session.finish();
}
void run_second(TransportPtr transport) {
  Session session(std::move(transport), hello_of("solver"), patience_s);
  for (int step = 0; step < 20; ++step) {
    const bridge::FrameView& frame = session.receive_frame();
    auto values = frame.find("velocity")->values<double>();
    for (double& value : values) value *= 2.0;
    send_field(session, frame.step, session.mine().offers[0], values);
  }
  session.finish();
}

void other_case(TransportPtr transport, const std::string& role, const std::string& name) {
  Hello hello = hello_of(role);
  hello.case_name = name;
  const auto start = Deadline::Clock::now();
  require_none(failure_of([&] { Session session(std::move(transport), hello, patience_s); },
                          Kind::mismatch, "given: dem runs 'pipe', solver runs 'bed'"));
  require(seconds(start) < 5.0, "the wrong case was noticed late");
}
void other_case_first(TransportPtr transport) { other_case(std::move(transport), "dem", "pipe"); }
void other_case_second(TransportPtr transport) {
  other_case(std::move(transport), "solver", "bed");
}

// A program of another version: each side names both versions.
void other_version_first(TransportPtr transport) {
  Bytes hello;
  bridge::encode_text(hello, bridge::MessageKind::hello, "{}");
  hello[12] = std::byte{9};
  send(*transport, hello);
  receive(*transport);  // the hello of the side under test
  bridge::FrameView view;
  const Bytes answer = receive(*transport);
  bridge::decode(answer, view);
  require(view.kind == bridge::MessageKind::error &&
              view.text.find("protocol version; given: 9; allowed: 1") != std::string_view::npos,
          "the versions were not told");
}
void other_version_second(TransportPtr transport) {
  require_none(
      failure_of([&] { Session session(std::move(transport), hello_of("solver"), patience_s); },
                 Kind::wrong_version, "given: 9; allowed: 1"));
}

// An error of one program is the error of both.
void failing_first(TransportPtr transport) {
  Session session(std::move(transport), hello_of("dem"), patience_s);
  session.fail("checkpoint; given: a full disk; allowed: 1 GB free; to do: make room");
}
void failing_second(TransportPtr transport) {
  Session session(std::move(transport), hello_of("solver"), patience_s);
  require_none(failure_of([&] { session.receive_frame(); }, Kind::peer_failed, "a full disk"));
}

// A program that simply ends (an exception, say) does not leave the other one waiting.
void leaving_first(TransportPtr transport) {
  const Session session(std::move(transport), hello_of("dem"), patience_s);
}
void leaving_second(TransportPtr transport) {
  Session session(std::move(transport), hello_of("solver"), patience_s);
  require_none(
      failure_of([&] { session.receive_frame(); }, Kind::peer_failed, "without saying goodbye"));
}

}  // namespace

const std::vector<ConformanceCase>& conformance_cases() {
  static const std::vector<ConformanceCase> cases = {
      {"Echo", echo_first, echo_second},
      {"Order", order_first, order_second},
      {"CrossingLargeFrames", crossing_first, crossing_second},
      {"SlowPeer", slow_first, slow_second},
      {"ClosedPeer", close_first, close_second},
      {"WritingToAClosedPeer", deaf_first, deaf_second},
      {"DamagedFrame", damage_first, damage_second},
      {"WholeRun", run_first, run_second},
      {"WrongCase", other_case_first, other_case_second},
      {"WrongVersion", other_version_first, other_version_second},
      {"FailingPeer", failing_first, failing_second},
      {"LeavingPeer", leaving_first, leaving_second},
  };
  return cases;
}

}  // namespace powderlink::test
