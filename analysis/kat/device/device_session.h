// SPDX-License-Identifier: GPL-3.0-or-later
/// \file device_session.h
/// Commands to a KAT device and its answers. Every line goes to the listener as it comes.
/// A damaged line ends nothing: the device keeps its last drop until the next is armed, so that a
/// damaged report is asked for again, and so is the answer of a command that changes nothing. What may
/// have been done and is not known (arm, abort, clear, selftest) is not sent twice.
/// Errors: InvalidInput for a refusal, with the device's own code and advice, for silence, and for
/// answers that stay damaged.
/// Tests: tests/analysis/kat/kat_device_test.cpp, tests/analysis/kat/kat_device_live_test.cpp
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "analysis/kat/device/drop_log.h"
#include "analysis/kat/device/serial_link.h"

namespace powderlink::analysis {

class DeviceSession {
 public:
  using Listener = std::function<void(const std::string& line)>;

  /// \param wait_s  longest time to the answer of a command, and to the end of a drop
  DeviceSession(const std::string& port, unsigned baud, double wait_s, Listener listener);

  /// `status`, `set` with "key=value" ...; returns when the device has done it: `drop` with its
  /// report, `selftest` with its result, `config` and `report` with all their lines.
  void command(const std::string& word, const std::vector<std::string>& fields = {});

  DropLog& log() { return log_; }

 private:
  enum class Ending {
    done,       ///< all lines came, whole or not
    taken,      ///< the device has the command; nothing more comes after a damaged line
    unknown,    ///< the same, but whether it has the command was in the damaged line
    not_taken,  ///< the device got a damaged line itself
  };
  Ending exchange(const std::string& word, const std::string& text, int again);
  std::optional<kat::Line> next(const std::string& word, const std::string& last, bool may_be_cut);
  [[noreturn]] void refused(const std::string& word, const kat::Line& line) const;
  [[noreturn]] void unreadable(const std::string& word, bool holds_drop) const;

  SerialLink link_;
  std::string port_;
  Listener listener_;
  std::chrono::steady_clock::duration wait_;
  std::chrono::steady_clock::time_point until_;
  std::string damaged_;  // last damaged line since the command was sent
  DropLog log_;
};

}  // namespace powderlink::analysis
