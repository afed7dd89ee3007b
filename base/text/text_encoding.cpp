// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/text/text_encoding.h"

#include <fmt/format.h>
#include <iconv.h>
#include <utf8.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <iterator>
#include <memory>
#include <optional>
#include <string_view>

#include "base/invalid_input.h"

namespace powderlink {

namespace {

using namespace std::string_view_literals;

const char* const kToDo =
    "save it again as UTF-8: \"CSV UTF-8\" in a spreadsheet, \"Save with encoding\" in an editor";

struct Mark {
  std::string_view bytes;
  const char* name;
};
// The longer first: UTF-32LE begins as UTF-16LE.
constexpr std::array<Mark, 5> kByteOrderMarks = {{{"\xEF\xBB\xBF"sv, "UTF-8"},
                                                  {"\xFF\xFE\0\0"sv, "UTF-32LE"},
                                                  {"\0\0\xFE\xFF"sv, "UTF-32BE"},
                                                  {"\xFF\xFE"sv, "UTF-16LE"},
                                                  {"\xFE\xFF"sv, "UTF-16BE"}}};
constexpr std::array<Mark, 10> kNoText = {
    {{"PK\x03\x04"sv, "a workbook (.xlsx, .ods) or another zip archive"},
     {"\xD0\xCF\x11\xE0"sv, "a workbook of Excel (.xls)"},
     {"\x1F\x8B"sv, "a compressed file (gzip)"},
     {"%PDF"sv, "a PDF"},
     {"\x89PNG"sv, "a picture (PNG)"},
     {"\xFF\xD8\xFF"sv, "a picture (JPEG)"},
     {"II*\0"sv, "a picture (TIFF)"},
     {"MM\0*"sv, "a picture (TIFF)"},
     {"\x89HDF"sv, "an HDF5 file"},
     {"SQLite format"sv, "a database"}}};

bool begins_with(std::string_view text, std::string_view start) {
  return text.substr(0, start.size()) == start;
}

std::size_t line_of(std::string_view text, std::size_t place) {
  return 1 + static_cast<std::size_t>(
                 std::count(text.begin(), text.begin() + static_cast<long>(place), '\n'));
}

/// Position of the first byte that cannot be converted, or the text.
std::optional<std::string> converted(std::string_view bytes, const std::string& from,
                                     std::size_t& bad) {
  struct Close {
    void operator()(void* handle) const { ::iconv_close(handle); }
  };
  const iconv_t opened = ::iconv_open("UTF-8", from.c_str());
  if (reinterpret_cast<std::intptr_t>(opened) == -1) {
    bad = 0;
    return std::nullopt;
  }
  const std::unique_ptr<void, Close> handle(opened);
  std::string copy(bytes), result(4 * bytes.size() + 4, '\0');
  char* in = copy.data();
  char* out = result.data();
  std::size_t in_left = copy.size(), out_left = result.size();
  if (::iconv(handle.get(), &in, &in_left, &out, &out_left) == static_cast<std::size_t>(-1)) {
    bad = copy.size() - in_left;
    return std::nullopt;
  }
  result.resize(result.size() - out_left);
  return result;
}

/// UTF-16 of western text without a mark: every second byte is 0.
const char* utf16_without_mark(std::string_view bytes) {
  constexpr double most = 0.9;
  std::array<std::size_t, 2> zeros{};
  for (std::size_t i = 0; i < bytes.size(); ++i) zeros[i % 2] += bytes[i] == '\0' ? 1 : 0;
  const std::size_t pairs = bytes.size() / 2;
  const auto enough = static_cast<std::size_t>(most * static_cast<double>(pairs));
  if (bytes.size() < 4 || bytes.size() % 2 != 0) return nullptr;
  if (zeros[0] == 0 && zeros[1] >= enough) return "UTF-16LE";
  if (zeros[1] == 0 && zeros[0] >= enough) return "UTF-16BE";
  return nullptr;
}

/// Windows-1252, with UTF-8 where that is in places, and U+FFFD for bytes that are neither: labels of
/// other countries (GBK, Shift JIS, Windows-1251) do not keep the numbers beside them from being read.
std::string western(std::string_view bytes) {
  std::string text;
  for (auto at = bytes.begin(); at != bytes.end(); ++at) {
    const auto bad = utf8::find_invalid(at, bytes.end());
    text.append(at, bad);
    at = bad;
    if (at == bytes.end()) break;
    std::size_t place = 0;
    const auto letter = converted(std::string_view(&*at, 1), "CP1252", place);
    text += letter ? *letter : "\uFFFD";
  }
  return text;
}

void unify_ends_of_lines(std::string& text) {
  if (text.find('\r') == std::string::npos) return;
  std::string unified;
  unified.reserve(text.size());
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] != '\r') {
      unified += text[i];
    } else {
      unified += '\n';
      if (i + 1 < text.size() && text[i + 1] == '\n') ++i;
    }
  }
  text = std::move(unified);
}

Text decoded_as(std::string_view bytes, const std::string& encoding, const std::string& file) {
  std::size_t bad = 0;
  auto text = converted(bytes, encoding, bad);
  if (text) return {std::move(*text), encoding};
  throw InvalidInput(
      fmt::format("{}, line {}: encoding", file, line_of(bytes, bad)),
      fmt::format("a byte 0x{:02X} that {} does not have",
                  static_cast<unsigned char>(bytes[std::min(bad, bytes.size() - 1)]), encoding),
      "text in one encoding, UTF-8 at best", kToDo);
}

}  // namespace

Text decoded(const std::string& bytes, const std::filesystem::path& path) {
  const std::string file = path.string();
  std::string_view all(bytes);
  Text text;
  for (const Mark& mark : kNoText) {
    if (!begins_with(all, mark.bytes)) continue;
    throw InvalidInput(file, std::string(mark.name), "text, such as CSV",
                       "save the table as text: File > Save As, \"CSV UTF-8\"");
  }
  for (const Mark& mark : kByteOrderMarks) {
    if (!text.encoding.empty() || !begins_with(all, mark.bytes)) continue;
    all.remove_prefix(mark.bytes.size());
    text = decoded_as(all, mark.name, file);
  }
  if (text.encoding.empty()) {
    if (const char* wide = utf16_without_mark(all)) {
      text = decoded_as(all, wide, file);
    } else if (utf8::is_valid(bytes.begin(), bytes.end())) {
      text = {bytes, "UTF-8"};
    } else {
      text = {western(all), "Windows-1252"};
    }
  }
  if (const std::size_t nul = text.utf8.find('\0'); nul != std::string::npos) {
    throw InvalidInput(fmt::format("{}, line {}", file, line_of(text.utf8, nul)),
                       "a byte 0: a file that is no text, or a damaged one", "text, such as CSV",
                       "save the table as text again");
  }
  unify_ends_of_lines(text.utf8);
  return text;
}

std::string for_terminal(const std::string& text) {
  std::string valid, result;
  utf8::replace_invalid(text.begin(), text.end(), std::back_inserter(valid));
  for (auto at = valid.begin(); at != valid.end();) {
    const std::uint32_t code = utf8::unchecked::next(at);
    const bool control = (code < 0x20 && code != '\n') || (code >= 0x7F && code < 0xA0);
    utf8::unchecked::append(!control ? code : code == '\t' ? ' ' : '?', std::back_inserter(result));
  }
  return result;
}

}  // namespace powderlink
