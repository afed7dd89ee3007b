// SPDX-License-Identifier: GPL-3.0-or-later
#include "kat_console.h"

#include "kat_text.h"

namespace kat {

const Console::Entry Console::kCommands[] = {
    {"version", [](Console& c) { return c.version(); }},
    {"status", [](Console& c) { return c.status(); }},
    {"config", [](Console& c) { return c.show_config(); }},
    {"set", [](Console& c) { return c.set(); }},
    {"selftest", [](Console& c) { return c.self_test(); }},
    {"arm", [](Console& c) { return c.arm(); }},
    {"drop", [](Console& c) { return c.drop(); }},
    {"abort", [](Console& c) { return c.abort(); }},
    {"clear", [](Console& c) { return c.clear(); }},
    {"report", [](Console& c) { return c.report(); }},
};

void Console::send(LineWriter line) {
  const char* text = line.finish();
  output_.write(text, line.length());
}

void Console::receive(char c) {
  if (!reader_.take(c)) return;
  Code code = reader_.trouble();
  if (code == Code::none) code = line_.parse(reader_.text(), reader_.length());
  const bool abort = code == Code::none && same_text(line_.word(), "abort");
  if (machine_.measuring() && !abort) {
    refuse_later(code);
  } else {
    command(code);
  }
}

void Console::refuse_later(Code trouble) {
  if (++late_ > 1) return;
  late_name_ = "-";
  late_code_ = trouble;
  if (trouble != Code::none) return;
  const Entry* entry = find(line_.word());
  late_code_ = entry == nullptr ? Code::unknown_command : Code::wrong_state;
  if (entry != nullptr) late_name_ = entry->name;
}

/// The first by its name, the others without.
bool Console::tell_refused() {
  if (late_ == 0) return false;
  send(LineWriter("error").text("cmd", late_name_).text("code", code_name(late_code_)));
  --late_;
  late_name_ = "-";
  late_code_ = Code::wrong_state;
  return true;
}

void Console::command(Code trouble) {
  if (trouble != Code::none) {
    send(LineWriter("error").text("cmd", "-").text("code", code_name(trouble)));
    return;
  }
  const Code code = run(line_.word());
  if (code != Code::none) {
    const char* name = code == Code::unknown_command ? "-" : line_.word();
    send(LineWriter("error").text("cmd", name).text("code", code_name(code)));
  }
}

const Console::Entry* Console::find(const char* name) {
  for (const Entry& entry : kCommands) {
    if (same_text(entry.name, name)) return &entry;
  }
  return nullptr;
}

Code Console::run(const char* name) {
  const Entry* entry = find(name);
  if (entry == nullptr) return Code::unknown_command;
  const Code code = entry->run(*this);
  if (code == Code::none) send(LineWriter("ok").text("cmd", name));
  return code;
}

Code Console::version() {
  send(LineWriter("version").text("device", "kat").number("firmware", 1));
  return Code::none;
}

const char* Console::level(bool value, const char* yes, const char* no) const {
  if (!machine_.sensors_on()) return "-";
  return value ? yes : no;
}

Code Console::status() {
  LineWriter line("status");
  line.text("state", state_name(machine_.state()))
      .text("fault", code_name(machine_.last().fault))
      .number("n", machine_.last().number)
      .text("magnet", machine_.magnet_on() ? "on" : "off")
      .text("sensors", machine_.sensors_on() ? "on" : "off")
      .text("beam", level(machine_.beam_blocked(), "blocked", "clear"))
      .text("contact", level(machine_.contact_closed(), "closed", "open"));
  send(line);
  return Code::none;
}

Code Console::show_config() {
  sending_ = Sending::config;
  next_ = 0;
  return Code::none;
}

Code Console::set() { return machine_.configure(line_); }
Code Console::self_test() { return machine_.self_test(); }
Code Console::arm() { return machine_.arm(); }
Code Console::drop() { return machine_.drop(); }
Code Console::abort() { return machine_.abort(); }
Code Console::clear() { return machine_.clear(); }

Code Console::report() {
  if (machine_.state() == State::armed) return Code::wrong_state;  // and none comes while it falls
  if (machine_.last().number == 0) return Code::no_report;
  sending_ = Sending::report;
  sent_ = machine_.last().number;
  next_ = 0;
  asked_ = true;
  return Code::none;
}

void Console::poll() {
  if (machine_.measuring() || !output_.ready()) return;
  if (tell_refused() || send_next()) return;
  notice_self_test();
  notice_state();
}

bool Console::send_next() {
  if (sending_ == Sending::nothing) return false;
  if (sending_ == Sending::config) {
    const ConfigKey& key = config_key(next_);
    send(LineWriter("config")
             .text("key", key.name)
             .number("value", machine_.config().*key.value)
             .number("smallest", key.smallest)
             .number("largest", key.largest));
    if (++next_ < kConfigKeys) return true;
    send(LineWriter("done").text("cmd", "config"));
    sending_ = Sending::nothing;
    return true;
  }
  // Another drop has begun: the rest of this report is gone, and its missing end tells so.
  if (sent_ != machine_.last().number) {
    sending_ = Sending::nothing;
    asked_ = false;
    return false;
  }
  send(drop_line(machine_.last(), next_));
  if (++next_ < machine_.last().lines()) return true;
  if (asked_) send(LineWriter("done").text("cmd", "report"));
  asked_ = false;
  sending_ = Sending::nothing;
  machine_.report_sent();
  return true;
}

void Console::notice_self_test() {
  if (told_tests_ == machine_.self_tests()) return;
  told_tests_ = machine_.self_tests();
  const Code found = machine_.self_test_result();
  send(LineWriter("selftest")
           .text("result", found == Code::none ? "pass" : "fail")
           .text("found", code_name(found)));
}

void Console::notice_state() {
  const State state = machine_.state();
  const bool ended = state == State::report || state == State::fault;
  if (ended && sent_ != machine_.last().number) {
    sending_ = Sending::report;
    sent_ = machine_.last().number;
    next_ = 0;
  }
  if (state == told_) return;
  told_ = state;
  send(LineWriter("state").text("name", state_name(state)));
}

}  // namespace kat
