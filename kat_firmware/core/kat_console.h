// SPDX-License-Identifier: GPL-3.0-or-later
/// \file kat_console.h
/// The protocol on one port: commands in, answers, changes of state and reports out. Several consoles
/// may share a machine (USB and BLE). One line per poll(), so that a slow port does not hold the loop.
///
///   version, status, config, set KEY=VALUE..., selftest, arm, drop, abort, clear, report
///
/// While something falls nothing is sent, as a port's own interrupts would delay those of the edges:
/// `abort` ends the test at once, every other line is refused, and told so when the test has ended.
///
/// Every command is answered by `ok` or `error` with a code. The lines of version and status come before
/// their `ok`; those of config and report after it, with `done` behind them.
/// Tests: tests/kat_firmware/console_test.cpp
#ifndef KAT_CONSOLE_H
#define KAT_CONSOLE_H

#include <stdint.h>

#include "kat_machine.h"

namespace kat {

class Output {
 public:
  /// False while the port cannot take a line: it is then asked again later.
  virtual bool ready() = 0;
  virtual void write(const char* text, uint16_t length) = 0;

 protected:
  ~Output() = default;
};

class Console {
 public:
  Console(Machine& machine, Output& output) : machine_(machine), output_(output) {}
  void receive(char c);
  void poll();

 private:
  using Command = Code (*)(Console&);
  struct Entry {
    const char* name;
    Command run;
  };
  enum class Sending : uint8_t { nothing, config, report };

  void command(Code trouble);
  void refuse_later(Code trouble);
  bool tell_refused();
  static const Entry* find(const char* name);
  Code run(const char* name);
  void send(LineWriter line);
  const char* level(bool value, const char* yes, const char* no) const;
  void notice_state();
  void notice_self_test();
  bool send_next();

  Code version();
  Code status();
  Code show_config();
  Code set();
  Code self_test();
  Code arm();
  Code drop();
  Code abort();
  Code clear();
  Code report();

  static const Entry kCommands[];

  Machine& machine_;
  Output& output_;
  LineReader reader_;
  Line line_;
  State told_ = State::idle;
  uint32_t told_tests_ = 0;
  uint32_t sent_ = 0;  // number of the drop that was reported, or is being
  Sending sending_ = Sending::nothing;
  uint8_t next_ = 0;
  uint16_t late_ = 0;            // lines that were refused while it fell
  const char* late_name_ = "-";  // of the first of them, and why
  Code late_code_ = Code::none;
  bool asked_ = false;  // the report was asked for: `done` after it
};

}  // namespace kat

#endif
