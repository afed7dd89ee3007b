// SPDX-License-Identifier: GPL-3.0-or-later
/// \file simulated_device.h
/// The device's own core, driven by a simulated drop, on a pseudo-terminal. Its time is not ours: a
/// turn of its loop is 5 ms of its world.
#pragma once

#include <poll.h>
#include <pty.h>
#include <termios.h>
#include <unistd.h>

#include <atomic>
#include <string>
#include <thread>

#include "kat_firmware/core/kat_console.h"
#include "tests/kat_firmware/simulated_board.h"

namespace kat {

class SimulatedDevice : public Output {
 public:
  SimulatedBoard board;
  std::string greeting;  ///< noise before the first answer
  bool silent = false;
  /// What becomes of a line on its way, such as a disturbed cable.
  std::function<std::string(const std::string&)> on_the_way = [](const std::string& s) {
    return s;
  };

  SimulatedDevice() {
    char name[256];
    termios raw{};
    cfmakeraw(&raw);
    if (openpty(&fd_, &other_, name, &raw, nullptr) == 0) port_ = name;
  }
  ~SimulatedDevice() {
    stop_ = true;
    if (thread_.joinable()) thread_.join();
    ::close(fd_);
    ::close(other_);
  }
  const std::string& port() const { return port_; }
  void start() {
    thread_ = std::thread([this] { loop(); });
  }

  bool ready() override { return true; }
  void write(const char* text, uint16_t length) override {
    send(on_the_way(std::string(text, length)));
  }

 private:
  void send(const std::string& text) {
    if (!silent && ::write(fd_, text.data(), text.size()) < 0) stop_ = true;
  }
  void loop() {
    if (!greeting.empty()) send(greeting);
    while (!stop_) {
      pollfd waiting{fd_, POLLIN, 0};
      char bytes[64];
      if (::poll(&waiting, 1, 1) > 0) {
        const ssize_t n = ::read(fd_, bytes, sizeof(bytes));
        for (ssize_t i = 0; i < n; ++i) console_.receive(bytes[i]);
      }
      board.run(machine_, 5000, 500, [this] { console_.poll(); });
    }
  }

  Machine machine_{board};
  Console console_{machine_, *this};
  int fd_ = -1, other_ = -1;
  std::string port_;
  std::atomic<bool> stop_{false};
  std::thread thread_;
};

}  // namespace kat
