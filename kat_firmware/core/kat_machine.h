// SPDX-License-Identifier: GPL-3.0-or-later
/// \file kat_machine.h
/// The Kinetic Adhesion Test as a state machine. Interrupts call edge(), the loop calls poll().
///
///   idle - arm -> armed - drop -> released -> beam_entered -> beam_left -> impact <-> contact_ended
///   -> report -> idle;  any of them -> fault - clear -> idle;  idle - selftest -> self_test -> idle
///
/// Every state but idle and fault has a limit. In report, fault and idle magnet and sensors are off.
/// A test either ends in report, measured from a complete and consistent set of edges, or in a fault
/// with a name. docs/kat_device.md has the table. Tests: tests/kat_firmware/machine_test.cpp,
/// tests/kat_firmware/fuzz_test.cpp
#ifndef KAT_MACHINE_H
#define KAT_MACHINE_H

#include <stdint.h>

#include "kat_board.h"
#include "kat_config.h"
#include "kat_drop.h"
#include "kat_ring.h"

namespace kat {

class Machine {
 public:
  explicit Machine(Board& board) : board_(board) {}

  /// From interrupts. Edges outside a test are not kept.
  void edge(EdgeKind kind, uint32_t time_us) {
    if (listening_) ring_.push(kind, time_us);
  }
  void poll();

  // Commands: Code::none, or why they were refused; a refused one changes nothing.
  Code arm();
  Code drop();
  Code abort();
  Code clear();
  Code self_test();
  Code configure(const Line& line);
  void report_sent();  ///< somebody has the report

  State state() const { return state_; }
  bool measuring() const { return state_ >= State::released && state_ <= State::contact_ended; }
  bool sensors_on() const { return sensors_; }
  bool magnet_on() const { return magnet_; }
  bool beam_blocked() { return board_.beam_blocked(); }  ///< means something with sensors_on()
  bool contact_closed() { return board_.contact_closed(); }
  const Config& config() const { return config_; }
  const Drop& last() const { return drop_; }  ///< changes from arm to its report or fault only
  Code self_test_result() const { return tested_; }    ///< of the last one
  uint32_t self_tests() const { return self_tests_; }  ///< that were finished

 private:
  void power(bool magnet, bool sensors);
  void enter(State state, uint32_t time_us);
  void fail(Code fault);
  void advance(uint32_t time_us);
  void handle(const Edge& edge);
  void beam(bool blocked, uint32_t time_us);
  void contact(bool closed, uint32_t time_us);
  void vibration(uint32_t time_us);
  void struck(uint32_t time_us);
  void sample();
  void finish();
  Code levels();
  uint32_t since_release(uint32_t time_us) const { return time_us - released_us_; }

  Board& board_;
  Config config_;
  Drop drop_;
  EdgeRing ring_;
  State state_ = State::idle;
  Code tested_ = Code::none;
  uint32_t since_us_ = 0;     // of the state
  uint32_t released_us_ = 0;  // of the magnet
  uint32_t struck_us_ = 0;    // first sign of the impact
  uint32_t self_tests_ = 0;
  bool magnet_ = false, sensors_ = false;
  volatile bool listening_ = false;
};

}  // namespace kat

#endif
