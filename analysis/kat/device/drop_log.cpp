// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/kat/device/drop_log.h"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>

#include "base/invalid_input.h"

namespace powderlink::analysis {

namespace {

constexpr std::size_t kShown = 60;  // of a line in a message

}  // namespace

std::string printable(const std::string& line) {
  std::string text;
  for (const char c : line.substr(0, kShown)) text += c >= ' ' && c <= '~' ? c : '?';
  return "'" + text + (line.size() > kShown ? "...'" : "'");
}

void DropLog::damaged(int line, const std::string& what, const std::string& given,
                      const std::string& to_do) {
  const std::string where = fmt::format("{}, line {}: {}", name_, line, what);
  if (!skip_damaged_) {
    throw InvalidInput(where, given, "whole lines of the device, as it sent them",
                       to_do + "; or leave damaged drops out with --skip-damaged");
  }
  notes_.push_back(where + ", left out: " + given);
}

void DropLog::unreadable(const std::string& text, kat::Code code) {
  unreadable_.push_back({line_, kat::code_name(code), printable(text), kat::code_advice(code)});
}

void DropLog::note_unreadable() {
  for (const Unreadable& u : unreadable_)
    notes_.push_back(fmt::format("{}, line {}: no message of the device ({}): {}", name_, u.line,
                                 u.code, u.text));
  unreadable_.clear();
}

/// A report that lost a line: to the first that cannot be read, if there is one.
void DropLog::broken(const std::string& what, const std::string& given) {
  const std::vector<Unreadable> causes = std::move(unreadable_);
  unreadable_.clear();
  if (causes.empty()) return damaged(line_, what, given, "ask the device for its report again");
  const Unreadable& first = causes.front();
  damaged(first.line, "damaged line (" + first.code + ")", first.text, first.advice);
}

void DropLog::take_message(const std::string& text) {
  kat::Line parsed;
  const kat::Code code = parsed.parse(
      text.data(), static_cast<uint16_t>(std::min<std::size_t>(text.size(), UINT16_MAX)));
  if (code != kat::Code::none) return unreadable(text, code);
  const char* number = parsed.find("n");
  if (number == nullptr) return;  // an answer, or a command that was echoed
  const bool begins = std::string(parsed.word()) == "drop";
  const bool inside = reader_.inside();
  if (begins && inside)
    broken("cut report", fmt::format("drop {} without its end", reader_.drop().number));
  if (begins) {
    spoiled_ = false;
    note_unreadable();
  }
  switch (reader_.take(parsed)) {
    case kat::DropReader::Result::whole:
      drops_.push_back({reader_.drop(), fmt::format("{}, line {}", name_, line_)});
      note_unreadable();
      break;
    case kat::DropReader::Result::broken:
      if (spoiled_) break;
      spoiled_ = true;
      if (!begins && !inside)
        broken("cut report", fmt::format("drop {} without its beginning", number));
      else
        broken("broken report", printable(text));
      break;
    default:
      break;
  }
}

void DropLog::take(const std::string& line) {
  ++line_;
  if (!line.empty() && line[0] == '#') return;
  constexpr std::size_t none = std::string::npos;
  static const std::string header = "KAT";
  const auto next_header = [&](std::size_t from) {
    for (std::size_t at = line.find(header, from); at != none; at = line.find(header, at + 1)) {
      const std::size_t after = at + header.size();
      if (after < line.size() && line[after] >= '0' && line[after] <= '9') return at;
    }
    return none;
  };
  for (std::size_t at = next_header(0); at != none;) {
    const std::size_t next = next_header(at + 1);
    const std::size_t star = line.find('*', at);
    const std::size_t end = star == none ? none : star + kat::kChecksumLength;
    std::string text = line.substr(at, std::min({end, next, line.size()}) - at);
    while (!text.empty() && (text.back() == '\r' || text.back() == ' ')) text.pop_back();
    take_message(text);
    at = next;
  }
}

void DropLog::end() {
  if (reader_.inside())
    broken("cut report", fmt::format("drop {} without its end", reader_.drop().number));
  note_unreadable();
}

DropLog read_drop_log(const std::filesystem::path& file, bool skip_damaged) {
  std::ifstream in(file, std::ios::binary);
  if (!in || std::filesystem::is_directory(file)) {
    throw InvalidInput("log of the KAT device", file.string(), "a file that can be read",
                       "check the path; --log writes one");
  }
  DropLog log(file.string(), skip_damaged);
  for (std::string line; std::getline(in, line);) {
    static const std::string wide("K\0A\0T", 5);  // with a mark or without
    if (log.empty() &&
        (line.compare(0, 2, "\xFF\xFE") == 0 || line.compare(0, 2, "\xFE\xFF") == 0 ||
         line.find(wide) != std::string::npos)) {
      throw InvalidInput("log of the KAT device", file.string() + ", in UTF-16",
                         "plain text, ASCII or UTF-8",
                         "save it as UTF-8; PowerShell writes UTF-16 with >");
    }
    log.take(line);
  }
  log.end();
  return log;
}

}  // namespace powderlink::analysis
