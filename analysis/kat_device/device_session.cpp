// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/kat_device/device_session.h"

#include <fmt/format.h>

#include <thread>

#include "models/invalid_input.h"

namespace powderlink::analysis {

namespace {

using Clock = std::chrono::steady_clock;

constexpr std::chrono::milliseconds kWarmUp{50};  // between two tries while the sensors warm up

/// The line, after which a command is done, when it is not its `ok`.
std::string last_of(const std::string& word) {
  if (word == "drop") return "end";
  if (word == "selftest") return "selftest";
  if (word == "config" || word == "report") return "done";
  return "";
}

std::string encode(const std::string& word, const std::vector<std::string>& fields) {
  kat::LineWriter line(word.c_str());
  for (const std::string& field : fields) {
    const std::size_t equal = field.find('=');
    if (equal == std::string::npos) {
      throw InvalidInput("--set", "'" + field + "'", "KEY=VALUE, such as carrier_um=10000",
                         "see the keys with --do config");
    }
    line.text(field.substr(0, equal).c_str(), field.substr(equal + 1).c_str());
  }
  if (!line.fits()) {
    throw InvalidInput("command " + word, fmt::format("{} fields", fields.size()),
                       "a line of at most 159 characters", "set fewer keys at a time");
  }
  // A line end first, so that noise before it stays by itself.
  return std::string("\n") + line.finish();
}

}  // namespace

DeviceSession::DeviceSession(const std::string& port, unsigned baud, double wait_s)
    : link_(port, baud),
      port_(port),
      wait_(std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(wait_s))),
      log_(port, false) {}

void DeviceSession::refused(const std::string& word, const kat::Line& line) const {
  const char* name = line.find("code");
  const kat::Code code = name != nullptr ? kat::find_code(name) : kat::Code::count;
  const bool known = code != kat::Code::count;
  throw InvalidInput(fmt::format("KAT device on {}: command {}", port_, word),
                     fmt::format("refused ({})", name != nullptr ? name : "no code"),
                     "what the device can do in its state",
                     known ? kat::code_advice(code) : "see docs/kat_device.md");
}

kat::Line DeviceSession::next(const std::string& word, const std::string& last) {
  while (true) {
    const auto left = std::chrono::duration_cast<std::chrono::milliseconds>(until_ - Clock::now());
    auto text = left.count() > 0 ? link_.read_line(left) : std::nullopt;
    if (!text) {
      throw InvalidInput(
          fmt::format("KAT device on {}: command {}", port_, word),
          fmt::format("no '{}' within {:g} s", last.empty() ? "ok" : last,
                      std::chrono::duration<double>(wait_).count()),
          "a device with this firmware that answers in time",
          "check that it is the right port and has the sketch; give more time with --wait");
    }
    // Noise without an end, as after plugging in, stands before the first line; the checksum tells
    // whether the rest is whole.
    const std::size_t begin = text->rfind("KAT1 ");
    if (begin != std::string::npos) text->erase(0, begin);
    lines_.push_back(*text);
    kat::Line line;
    if (line.parse(text->data(), static_cast<uint16_t>(text->size())) == kat::Code::none) {
      log_.take(*text);
      return line;
    }
    // Noise between lines is not held against it; a damaged line is.
    log_.take(*text);
  }
}

void DeviceSession::command(const std::string& word, const std::vector<std::string>& fields) {
  until_ = Clock::now() + wait_;
  const std::string text = encode(word, fields);
  link_.write(text);
  bool accepted = false;
  while (true) {
    const kat::Line line = next(word, accepted ? last_of(word) : "");
    const std::string answer = line.word();
    const char* to = line.find("cmd");
    const bool mine = to != nullptr && word == to;
    if (answer == "error" && to != nullptr) {
      const char* code = line.find("code");
      const bool nameless = std::string(to) == "-" && code != nullptr;
      // What came before our line end was noise, not our command.
      const bool noise = nameless && !accepted &&
                         (std::string(code) == "not_a_line" || std::string(code) == "noise" ||
                          std::string(code) == "no_checksum");
      if (noise) continue;
      if (mine && code != nullptr && kat::find_code(code) == kat::Code::warming_up) {
        std::this_thread::sleep_for(kWarmUp);
        link_.write(text);
        continue;
      }
      if (mine || nameless) refused(word, line);
    }
    if (mine && answer == "ok") accepted = true;
    const std::string last = last_of(word);
    if (accepted && (last.empty() || answer == last)) return;
  }
}

}  // namespace powderlink::analysis
