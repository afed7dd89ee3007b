// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/kat/device/device_session.h"

#include <fmt/format.h>

#include <algorithm>
#include <thread>

#include "base/invalid_input.h"

namespace powderlink::analysis {

namespace {

using Clock = std::chrono::steady_clock;

constexpr std::chrono::milliseconds kWarmUp{50};  // between two tries while the sensors warm up
constexpr std::chrono::milliseconds kSilence{
    1000};                 // after damage: the rest of the answer has come
constexpr int kAgain = 2;  // times that the same is asked for again

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

/// The device says that a drop has ended.
bool ended(const kat::Line& line) {
  const char* name = line.find("name");
  if (std::string(line.word()) != "state" || name == nullptr) return false;
  const kat::State state = kat::find_state(name);
  return state == kat::State::report || state == kat::State::fault;
}

}  // namespace

DeviceSession::DeviceSession(const std::string& port, unsigned baud, double wait_s,
                             Listener listener)
    : link_(port, baud),
      port_(port),
      listener_(std::move(listener)),
      wait_(std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(wait_s))),
      log_(port, true) {}

void DeviceSession::refused(const std::string& word, const kat::Line& line) const {
  const char* name = line.find("code");
  const kat::Code code = name != nullptr ? kat::find_code(name) : kat::Code::count;
  const bool known = code != kat::Code::count;
  throw InvalidInput(fmt::format("KAT device on {}: command {}", port_, word),
                     fmt::format("refused ({})", name != nullptr ? name : "no code"),
                     "what the device can do in its state",
                     known ? kat::code_advice(code) : "see docs/kat_device.md");
}

void DeviceSession::unreadable(const std::string& word, bool holds_drop) const {
  throw InvalidInput(
      fmt::format("KAT device on {}: command {}", port_, word),
      damaged_.empty() ? "an answer without its end" : "a damaged answer: " + damaged_,
      "whole lines of the device, as it sent them",
      holds_drop ? "check cable and speed; "
                   "the device holds the drop until the next is armed: --do report"
                 : "check cable and speed; --do status tells whether it was done");
}

std::optional<kat::Line> DeviceSession::next(const std::string& word, const std::string& last,
                                             bool may_be_cut) {
  while (true) {
    const bool cut = may_be_cut && (!damaged_.empty() || log_.inside());
    auto left = std::chrono::duration_cast<std::chrono::milliseconds>(until_ - Clock::now());
    if (cut) left = std::min(left, kSilence);
    auto text = left.count() > 0 ? link_.read_line(left) : std::nullopt;
    if (!text && cut) return std::nullopt;
    if (!text) {
      throw InvalidInput(
          fmt::format("KAT device on {}: command {}", port_, word),
          fmt::format("no '{}' within {:g} s{}", last.empty() ? "ok" : last,
                      std::chrono::duration<double>(wait_).count(),
                      damaged_.empty() ? "" : ", and the damaged line " + damaged_),
          "a device with this firmware that answers in time",
          "check that it is the right port and has the sketch; give more time with --wait");
    }
    // Noise without an end, as after plugging in, stands before the first line; the checksum tells
    // whether the rest is whole.
    const std::size_t begin = text->rfind("KAT1 ");
    if (begin != std::string::npos) text->erase(0, begin);
    if (listener_) listener_(*text);
    log_.take(*text);
    kat::Line line;
    if (line.parse(text->data(), static_cast<uint16_t>(text->size())) == kat::Code::none)
      return line;
    if (!text->empty()) damaged_ = printable(*text);
  }
}

DeviceSession::Ending DeviceSession::exchange(const std::string& word, const std::string& text,
                                              int again) {
  until_ = Clock::now() + wait_;
  damaged_.clear();
  link_.write(text);
  bool taken = false;
  while (true) {
    // Silence may be that of the fall, until something tells that it was taken, or of the warm-up.
    const bool may_be_cut = word == "drop" ? taken : word != "selftest";
    const auto line = next(word, taken ? last_of(word) : "", may_be_cut);
    if (!line) return taken ? Ending::taken : Ending::unknown;
    const std::string answer = line->word();
    const char* to = line->find("cmd");
    const bool mine = to != nullptr && word == to;
    if (answer == "error" && to != nullptr) {
      const char* name = line->find("code");
      const kat::Code code = name != nullptr ? kat::find_code(name) : kat::Code::count;
      const bool nameless = std::string(to) == "-";
      // What came before our line end was noise, not our command.
      if (nameless && !taken &&
          (code == kat::Code::not_a_line || code == kat::Code::noise ||
           code == kat::Code::no_checksum))
        continue;
      if (nameless && !taken && again < kAgain &&
          (code == kat::Code::bad_checksum || code == kat::Code::bad_field ||
           code == kat::Code::too_long))
        return Ending::not_taken;
      // Asked again while it still falls: it will have a report.
      const bool falls = word == "report" && again > 0 && code == kat::Code::wrong_state;
      if (mine && (code == kat::Code::warming_up || falls) && Clock::now() < until_) {
        std::this_thread::sleep_for(kWarmUp);
        link_.write(text);
        continue;
      }
      if (mine || nameless) refused(word, *line);
    }
    if (mine && answer == "ok") taken = true;
    // Its `ok` may have been the damaged line; a drop's end tells as well.
    const bool begins_report = answer == "drop" && line->find("n") != nullptr;
    if (word == "drop" && (begins_report || ended(*line))) taken = true;
    const std::string last = last_of(word);
    if (taken && (last.empty() || answer == last)) return Ending::done;
  }
}

void DeviceSession::command(const std::string& word, const std::vector<std::string>& fields) {
  const std::size_t known = log_.drops().size();
  const bool reports = word == "drop" || word == "report";
  const bool changes_nothing = word == "version" || word == "status" || word == "config" ||
                               word == "set" || word == "report";
  std::string asked = word, text = encode(word, fields);
  for (int again = 0;; ++again) {
    const Ending ending = exchange(asked, text, again);
    if (reports ? log_.drops().size() > known : ending == Ending::done) return;
    const bool drop_taken = word == "drop" && ending != Ending::not_taken;
    const bool may_repeat = changes_nothing || drop_taken || ending == Ending::not_taken;
    if (again == kAgain || !may_repeat) unreadable(word, reports);
    if (!drop_taken || asked == "report") continue;
    asked = "report";
    text = encode(asked, {});
  }
}

}  // namespace powderlink::analysis
