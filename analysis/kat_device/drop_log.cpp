// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/kat_device/drop_log.h"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>

#include "models/invalid_input.h"

namespace powderlink::analysis {

namespace {

constexpr std::size_t kShown = 60;  // of a line in a message

}  // namespace

std::string printable(const std::string& line) {
  std::string text;
  for (const char c : line.substr(0, kShown)) text += c >= ' ' && c <= '~' ? c : '?';
  return "'" + text + (line.size() > kShown ? "...'" : "'");
}

void DropLog::damaged(const std::string& what, const std::string& given, const std::string& to_do) {
  const std::string where = fmt::format("{}, line {}: {}", name_, line_, what);
  if (!skip_damaged_) {
    throw InvalidInput(where, given, "whole lines of the device, as it sent them",
                       to_do + "; or leave damaged drops out with --skip-damaged");
  }
  notes_.push_back(where + ", left out: " + given);
}

void DropLog::take(const std::string& text) {
  ++line_;
  std::string line = text;
  if (!line.empty() && line.back() == '\r') line.pop_back();
  if (line.compare(0, 3, "KAT") != 0) return;
  kat::Line parsed;
  const kat::Code code = parsed.parse(
      line.data(), static_cast<uint16_t>(std::min<std::size_t>(line.size(), UINT16_MAX)));
  if (code != kat::Code::none) {
    damaged(std::string("damaged line (") + kat::code_name(code) + ")", printable(line),
            kat::code_advice(code));
    return;  // if it was a drop's, that drop's count of lines tells
  }
  const bool begins = std::string(parsed.word()) == "drop";
  if (begins && reader_.inside()) {
    damaged("cut report", fmt::format("drop {} without its end", reader_.drop().number),
            "ask the device for its report again");
  }
  if (begins) spoiled_ = false;
  switch (reader_.take(parsed)) {
    case kat::DropReader::Result::whole:
      drops_.push_back({reader_.drop(), fmt::format("{}, line {}", name_, line_)});
      break;
    case kat::DropReader::Result::broken:
      if (!spoiled_) {
        spoiled_ = true;
        damaged("broken report", printable(line), "ask the device for its report again");
      }
      break;
    default:
      break;
  }
}

void DropLog::end() {
  if (reader_.inside()) {
    damaged("cut report", fmt::format("drop {} without its end", reader_.drop().number),
            "ask the device for its report again");
  }
}

DropLog read_drop_log(const std::filesystem::path& file, bool skip_damaged) {
  std::ifstream in(file, std::ios::binary);
  if (!in || std::filesystem::is_directory(file)) {
    throw InvalidInput("log of the KAT device", file.string(), "a file that can be read",
                       "check the path; --log writes one");
  }
  DropLog log(file.string(), skip_damaged);
  for (std::string line; std::getline(in, line);) log.take(line);
  log.end();
  return log;
}

}  // namespace powderlink::analysis
