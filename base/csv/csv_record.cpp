// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/csv/csv_record.h"

#include <algorithm>

namespace powderlink {

namespace {

constexpr std::string_view kNoBreakSpace = "\u00A0";

bool is_blank(char c) { return c == ' ' || c == '\t'; }

}  // namespace

std::string_view without_blanks(std::string_view text) {
  for (;;) {
    if (!text.empty() && is_blank(text.front())) {
      text.remove_prefix(1);
    } else if (text.substr(0, kNoBreakSpace.size()) == kNoBreakSpace) {
      text.remove_prefix(kNoBreakSpace.size());
    } else {
      break;
    }
  }
  for (;;) {
    if (!text.empty() && is_blank(text.back())) {
      text.remove_suffix(1);
    } else if (text.size() >= kNoBreakSpace.size() &&
               text.substr(text.size() - kNoBreakSpace.size()) == kNoBreakSpace) {
      text.remove_suffix(kNoBreakSpace.size());
    } else {
      break;
    }
  }
  return text;
}

std::string_view CsvReader::line_ahead() const {
  return text_.substr(at_, text_.find('\n', at_) - at_);
}

void CsvReader::skip_line() {
  const std::size_t end = text_.find('\n', at_);
  at_ = end == std::string_view::npos ? text_.size() : end + 1;
  ++line_;
}

CsvRecord CsvReader::read(char separator) {
  CsvRecord record;
  record.line = line_;
  const std::size_t start = at_;
  const auto skip_blanks = [&] {
    while (!at_end() && is_blank(text_[at_]) && text_[at_] != separator) ++at_;
  };
  const auto is_end = [&] { return at_end() || text_[at_] == '\n'; };
  if (separator == kBlanks) {
    while (!is_end() && is_blank(text_[at_])) ++at_;
  }
  for (;;) {
    skip_blanks();
    if (!at_end() && text_[at_] == '"') {
      std::string cell;
      ++at_;
      for (;;) {
        const std::size_t quote = text_.find('"', at_);
        if (quote == std::string_view::npos) {
          record.fault = CsvRecord::Fault::open_quotes;
          at_ = text_.size();
          break;
        }
        cell += text_.substr(at_, quote - at_);
        at_ = quote + 1;
        if (at_end() || text_[at_] != '"') break;
        cell += '"';
        ++at_;
      }
      record.cells.emplace_back(without_blanks(cell));
      line_ += static_cast<int>(std::count(cell.begin(), cell.end(), '\n'));
      skip_blanks();
      if (!is_end() && text_[at_] != separator) {
        if (record.fault == CsvRecord::Fault::none)
          record.fault = CsvRecord::Fault::text_after_quotes;
        while (!is_end() && text_[at_] != separator) ++at_;
      }
    } else {
      const std::size_t from = at_;
      while (!is_end() && text_[at_] != separator &&
             !(separator == kBlanks && is_blank(text_[at_])))
        ++at_;
      record.cells.emplace_back(without_blanks(text_.substr(from, at_ - from)));
    }
    if (separator == kBlanks) {
      while (!is_end() && is_blank(text_[at_])) ++at_;
      if (!is_end()) continue;
    }
    if (is_end()) break;
    ++at_;  // the separator
  }
  record.text = text_.substr(start, at_ - start);
  if (!at_end()) ++at_;
  ++line_;
  return record;
}

std::vector<std::string> cells_of(std::string_view record, char separator) {
  CsvReader reader(record);
  return reader.at_end() ? std::vector<std::string>{""} : reader.read(separator).cells;
}

}  // namespace powderlink
