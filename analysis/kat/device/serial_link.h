// SPDX-License-Identifier: GPL-3.0-or-later
/// \file serial_link.h
/// A serial port of which every wait has a limit. Errors are InvalidInput and name the port.
/// Tests: tests/analysis/kat/kat_device_test.cpp, with the device's own core on a pseudo-terminal
#pragma once

#include <boost/asio/io_context.hpp>
#include <boost/asio/serial_port.hpp>
#include <chrono>
#include <optional>
#include <string>

namespace powderlink::analysis {

class SerialLink {
 public:
  SerialLink(const std::string& port, unsigned baud);
  void write(const std::string& text);
  /// Without its end; nothing when none came in time.
  std::optional<std::string> read_line(std::chrono::milliseconds limit);

 private:
  boost::asio::io_context context_;
  boost::asio::serial_port port_;
  std::string name_;
  std::string waiting_;  // bytes after the last line
};

}  // namespace powderlink::analysis
