// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/kat/device/serial_link.h"

#include <array>
#include <boost/asio/buffer.hpp>
#include <boost/asio/write.hpp>

#include "base/invalid_input.h"

namespace powderlink::analysis {

namespace {

constexpr std::chrono::milliseconds kWriteLimit{2000};
constexpr std::size_t kLongestLine = 4096;  // noise without an end must not fill the memory

[[noreturn]] void lost(const std::string& port, const std::string& why) {
  throw InvalidInput("serial port", port + ": " + why,
                     "the port of a KAT device that is plugged in",
                     "look for it with 'ls /dev/ttyACM*', check the cable, "
                     "that you may use it (group dialout) and that no other program does");
}

}  // namespace

SerialLink::SerialLink(const std::string& port, unsigned baud) : port_(context_), name_(port) {
  namespace asio = boost::asio;
  boost::system::error_code problem;
  port_.open(port, problem);
  if (!problem) port_.set_option(asio::serial_port::baud_rate(baud), problem);
  if (!problem) port_.set_option(asio::serial_port::character_size(8), problem);
  if (!problem)
    port_.set_option(asio::serial_port::flow_control(asio::serial_port::flow_control::none),
                     problem);
  if (problem) lost(name_, problem.message());
}

void SerialLink::write(const std::string& text) {
  boost::system::error_code result = boost::asio::error::timed_out;
  boost::asio::async_write(
      port_, boost::asio::buffer(text),
      [&result](const boost::system::error_code& e, std::size_t) { result = e; });
  context_.restart();
  context_.run_for(kWriteLimit);
  if (!context_.stopped()) {
    port_.cancel();
    context_.run();
    result = boost::asio::error::timed_out;
  }
  if (result) lost(name_, "writing: " + result.message());
}

std::optional<std::string> SerialLink::read_line(std::chrono::milliseconds limit) {
  const auto until = std::chrono::steady_clock::now() + limit;
  while (true) {
    const std::size_t end = waiting_.find('\n');
    if (end != std::string::npos) {
      std::string line = waiting_.substr(0, end);
      waiting_.erase(0, end + 1);
      if (!line.empty() && line.back() == '\r') line.pop_back();
      return line;
    }
    if (waiting_.size() > kLongestLine) waiting_.clear();
    const auto left = until - std::chrono::steady_clock::now();
    if (left <= left.zero()) return std::nullopt;
    std::array<char, 256> bytes{};
    std::size_t count = 0;
    boost::system::error_code result;
    port_.async_read_some(boost::asio::buffer(bytes),
                          [&](const boost::system::error_code& e, std::size_t n) {
                            result = e;
                            count = n;
                          });
    context_.restart();
    context_.run_for(left);
    if (!context_.stopped()) {
      port_.cancel();
      context_.run();
    }
    if (result && result != boost::asio::error::operation_aborted)
      lost(name_, "reading: " + result.message());
    waiting_.append(bytes.data(), count);
  }
}

}  // namespace powderlink::analysis
