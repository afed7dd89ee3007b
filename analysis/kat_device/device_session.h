// SPDX-License-Identifier: GPL-3.0-or-later
/// \file device_session.h
/// Commands to a KAT device and its answers. Whatever it sends is kept, for the log.
/// Errors: InvalidInput for a refusal, with the device's own code and advice, and for silence.
/// Tests: tests/analysis/kat_device_port_test.cpp
#pragma once

#include <string>
#include <vector>

#include "analysis/kat_device/drop_log.h"
#include "analysis/kat_device/serial_link.h"

namespace powderlink::analysis {

class DeviceSession {
 public:
  /// \param wait_s  longest time to the answer of a command, and to the end of a drop
  DeviceSession(const std::string& port, unsigned baud, double wait_s);

  /// `status`, `set` with "key=value" ...; returns when the device has done it: `drop` with its
  /// report, `selftest` with its result, `config` and `report` with all their lines.
  void command(const std::string& word, const std::vector<std::string>& fields = {});

  const std::vector<std::string>& lines() const { return lines_; }  ///< all that came
  const DropLog& log() const { return log_; }

 private:
  kat::Line next(const std::string& word, const std::string& last);
  [[noreturn]] void refused(const std::string& word, const kat::Line& line) const;

  SerialLink link_;
  std::string port_;
  std::chrono::steady_clock::duration wait_;
  std::chrono::steady_clock::time_point until_;
  std::vector<std::string> lines_;
  DropLog log_;
};

}  // namespace powderlink::analysis
