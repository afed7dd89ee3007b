// SPDX-License-Identifier: GPL-3.0-or-later
/// \file deadline.h
/// Every wait of the bridge ends at a deadline.
#pragma once

#include <sched.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <sstream>
#include <string>
#include <thread>

#include "coupling/bridge/bridge_error.h"

namespace powderlink::bridge {

class Deadline {
 public:
  using Clock = std::chrono::steady_clock;

  /// From now on; 0 looks once and does not wait.
  explicit Deadline(double timeout_s) : timeout_s_(timeout_s), end_(Clock::now()) {
    constexpr double longest_s = 1e8;
    if (!(timeout_s >= 0.0 && timeout_s <= longest_s)) {
      throw BridgeError(BridgeError::Kind::bad_input, "timeout", std::to_string(timeout_s) + " s",
                        "0 to 1e8 s", "give the timeout in seconds, e.g. 60");
    }
    end_ += std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(timeout_s));
  }

  bool expired() const { return Clock::now() >= end_; }
  double timeout_s() const { return timeout_s_; }
  double remaining_s() const {
    return std::max(0.0, std::chrono::duration<double>(end_ - Clock::now()).count());
  }
  /// For poll(): rounded up, so that a wait does not end just before the deadline.
  int remaining_ms() const {
    return static_cast<int>(std::min(1e6, std::ceil(1e3 * remaining_s())));
  }

  /// \param waited_for  e.g. "a frame from solver"
  BridgeError error(const std::string& waited_for) const {
    std::ostringstream text;
    text << "nothing within " << timeout_s_ << " s";
    return {BridgeError::Kind::timeout, "waiting for " + waited_for, text.str(),
            "an answer before the timeout",
            "see the log of the other program: it hangs, is slower than the timeout, "
            "or was never started; a longer timeout helps only when it is slow"};
  }

 private:
  double timeout_s_;
  Clock::time_point end_;
};

/// Pauses of a polling loop: none at first (an answer within microseconds), then giving the core to
/// others, then sleeping, so that a wait of a whole solver step costs next to nothing.
class Backoff {
 public:
  void pause() {
    if (++calls_ < spins) return;
    if (calls_ == spins) start_ = Deadline::Clock::now();
    if (Deadline::Clock::now() - start_ < std::chrono::milliseconds(1)) {
      sched_yield();
    } else {
      std::this_thread::sleep_for(std::chrono::microseconds(50));
    }
  }

 private:
  static constexpr int spins = 200;
  int calls_ = 0;
  Deadline::Clock::time_point start_;
};

}  // namespace powderlink::bridge
