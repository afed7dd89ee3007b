// SPDX-License-Identifier: GPL-3.0-or-later
#include "kat_machine.h"

#include "kat_velocity.h"

namespace kat {

namespace {

/// Later than `limit` after `since`, on a clock that wraps around; an edge may be older than the
/// command that began the state, by the time between interrupt and loop.
bool past(uint32_t time_us, uint32_t since_us, uint32_t limit_us) {
  const uint32_t elapsed = time_us - since_us;
  return elapsed < 0x80000000U && elapsed > limit_us;
}

/// States that end in a fault when nothing happens.
const struct {
  State state;
  uint32_t Config::*limit_us;
  Code fault;
} kLimits[] = {
    {State::armed, &Config::arm_limit_us, Code::arm_timeout},
    {State::released, &Config::enter_limit_us, Code::no_beam_entry},
    {State::beam_entered, &Config::leave_limit_us, Code::no_beam_exit},
    {State::beam_left, &Config::impact_limit_us, Code::no_impact},
};

}  // namespace

void Machine::power(bool magnet, bool sensors) {
  magnet_ = magnet;
  sensors_ = sensors;
  board_.set_magnet(magnet);
  board_.set_sensors(sensors);
}

void Machine::enter(State state, uint32_t time_us) {
  state_ = state;
  since_us_ = time_us;
}

void Machine::fail(Code fault) {
  listening_ = false;
  power(false, false);
  drop_.fault = fault;
  drop_.state = state_;
  enter(State::fault, since_us_);
}

Code Machine::levels() {
  if (board_.beam_blocked()) return Code::beam_blocked;
  if (board_.contact_closed()) return Code::contact_closed;
  return Code::none;
}

Code Machine::arm() {
  if (state_ != State::idle) return Code::wrong_state;
  const uint32_t number = drop_.number + 1U;
  drop_ = Drop();
  drop_.number = number;
  drop_.carrier_um = config_.carrier_um;
  drop_.beam_um = config_.beam_um;
  drop_.latency_us = config_.latency_us;
  power(true, true);
  enter(State::armed, board_.now_us());
  return Code::none;
}

Code Machine::drop() {
  if (state_ != State::armed) return Code::wrong_state;
  const uint32_t now = board_.now_us();
  if (now - since_us_ < config_.warmup_us) return Code::warming_up;
  const Code code = levels();
  if (code != Code::none) return code;
  ring_.clear();
  released_us_ = board_.now_us();
  enter(State::released, released_us_);
  listening_ = true;
  power(false, true);
  return Code::none;
}

Code Machine::abort() {
  if (measuring()) {
    fail(Code::aborted);
    return Code::none;
  }
  const bool armed = state_ == State::armed;
  if (!armed && state_ != State::self_test) return Code::wrong_state;
  power(false, false);
  if (armed)
    drop_.fault = Code::aborted;  // during a self-test drop_ is the last drop, which was not
  enter(State::idle, since_us_);
  return Code::none;
}

Code Machine::clear() {
  if (state_ != State::fault) return Code::wrong_state;
  enter(State::idle, since_us_);
  return Code::none;
}

Code Machine::self_test() {
  if (state_ != State::idle) return Code::wrong_state;
  power(false, true);
  enter(State::self_test, board_.now_us());
  return Code::none;
}

Code Machine::configure(const Line& line) {
  if (state_ != State::idle) return Code::wrong_state;
  return set_config(config_, line);
}

void Machine::report_sent() {
  if (state_ == State::report) enter(State::idle, since_us_);
}

void Machine::poll() {
  // The clock before the ring: every edge up to `now` is in the ring then, so that a limit is not
  // found passed while the edge that kept it waits.
  const uint32_t now = board_.now_us();
  Edge edge;
  while (!ring_.overflowed() && ring_.pop(edge)) {
    advance(edge.time_us);
    if (measuring()) handle(edge);
  }
  if (measuring() && ring_.overflowed()) fail(Code::event_overflow);
  advance(now);
  sample();
}

void Machine::advance(uint32_t time_us) {
  for (const auto& limit : kLimits) {
    if (state_ == limit.state && past(time_us, since_us_, config_.*limit.limit_us)) {
      fail(limit.fault);
      return;
    }
  }
  if (state_ == State::self_test) {
    if (time_us - since_us_ < config_.warmup_us) return;
    tested_ = levels();
    ++self_tests_;
    power(false, false);
    enter(State::idle, time_us);
  } else if (state_ == State::report) {
    if (past(time_us, since_us_, config_.report_limit_us)) report_sent();
  } else if (state_ == State::impact) {
    if (past(time_us, struck_us_, config_.bounce_limit_us)) {
      fail(Code::no_rest);
    } else if (past(time_us, since_us_, config_.contact_limit_us)) {
      if (drop_.contacts.total() == 0) {
        fail(Code::no_contact);
      } else if (drop_.contacts.finished() == 0) {
        fail(Code::contact_stuck);
      } else {
        finish();  // the carrier rests on the anvil
      }
    }
  } else if (state_ == State::contact_ended) {
    if (past(time_us, struck_us_, config_.bounce_limit_us)) {
      fail(Code::no_rest);
    } else if (past(time_us, since_us_, config_.quiet_us)) {
      finish();
    }
  }
}

void Machine::handle(const Edge& edge) {
  switch (edge.kind) {
    case EdgeKind::beam_blocked:
    case EdgeKind::beam_clear:
      beam(edge.kind == EdgeKind::beam_blocked, edge.time_us);
      break;
    case EdgeKind::contact_closed:
    case EdgeKind::contact_open:
      contact(edge.kind == EdgeKind::contact_closed, edge.time_us);
      break;
    default:
      vibration(edge.time_us);
  }
}

void Machine::beam(bool blocked, uint32_t time_us) {
  if (state_ == State::released && blocked) {
    drop_.enter_us = since_release(time_us);
    enter(State::beam_entered, time_us);
  } else if (state_ == State::beam_entered && !blocked) {
    drop_.leave_us = since_release(time_us);
    enter(State::beam_left, time_us);
  } else if (state_ <= State::beam_left) {
    fail(Code::beam_out_of_order);
  }
  // After the impact the carrier may bounce through the beam.
}

void Machine::struck(uint32_t time_us) {
  struck_us_ = time_us;
  enter(State::impact, time_us);
}

void Machine::contact(bool closed, uint32_t time_us) {
  if (state_ < State::beam_left) {
    fail(Code::early_impact);
    return;
  }
  const uint32_t time = since_release(time_us);
  if (!drop_.contacts.edge(closed, time, config_.merge_us)) {
    fail(Code::contact_out_of_order);
    return;
  }
  if (state_ == State::beam_left) struck(time_us);
  if (drop_.touch_us == kNoValue) drop_.touch_us = time;
  enter(closed ? State::impact : State::contact_ended, time_us);
}

void Machine::vibration(uint32_t time_us) {
  if (state_ < State::beam_left) {
    fail(Code::early_impact);
    return;
  }
  if (drop_.vibration_us != kNoValue) return;  // it rattles on
  drop_.vibration_us = since_release(time_us);
  if (state_ == State::beam_left) struck(time_us);
}

void Machine::sample() {
  if (state_ != State::impact && state_ != State::contact_ended) return;
  const uint32_t closed = closed_switches(board_.switch_mV());
  if (closed != kNoValue && (drop_.switches == kNoValue || closed > drop_.switches))
    drop_.switches = closed;
  const uint32_t mg = board_.acceleration_mg();
  if (mg != kNoValue && (drop_.peak_mg == kNoValue || mg > drop_.peak_mg)) drop_.peak_mg = mg;
}

void Machine::finish() {
  if (config_.vibration != 0 && drop_.vibration_us == kNoValue) {
    fail(Code::no_vibration);
    return;
  }
  const Fall fall = free_fall(config_.carrier_um, config_.beam_um, drop_.leave_us - drop_.enter_us);
  if (fall.velocity_um_s == 0 ||
      !flight_agrees(drop_.touch_us - drop_.leave_us, fall.flight_us, config_.flight_permille)) {
    fail(Code::times_inconsistent);
    return;
  }
  drop_.velocity_um_s = fall.velocity_um_s;
  drop_.state = State::report;
  listening_ = false;
  power(false, false);
  enter(State::report, board_.now_us());
}

}  // namespace kat
