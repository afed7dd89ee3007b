// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/flow/restart/field_file.h"

#include <zlib.h>

#include <algorithm>
#include <array>
#include <fstream>
#include <optional>

namespace powderlink::analysis {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t kTail_bytes = 200;

std::string tail_of(std::ifstream& in) {
  in.seekg(0, std::ios::end);
  const auto size = static_cast<std::size_t>(in.tellg());
  std::string text(std::min(size, kTail_bytes), '\0');
  in.seekg(static_cast<std::streamoff>(size - text.size()));
  in.read(text.data(), static_cast<std::streamsize>(text.size()));
  return text;
}

/// The end of what the file inflates to; nothing when it cannot be inflated to its end.
std::optional<std::string> inflated_tail_of(const fs::path& file) {
  const gzFile in = gzopen(file.c_str(), "rb");
  if (in == nullptr) return {};
  std::string tail;
  std::array<char, 1 << 16> block{};
  int got = 0;
  while ((got = gzread(in, block.data(), block.size())) > 0) {
    tail.append(block.data(), static_cast<std::size_t>(got));
    if (tail.size() > kTail_bytes) tail.erase(0, tail.size() - kTail_bytes);
  }
  // What is no gzip file would be read as it is; one that breaks off is known when it is closed.
  const bool compressed = gzdirect(in) == 0;
  const bool whole = gzclose_r(in) == Z_OK && got == 0;
  if (!compressed || !whole) return {};
  return tail;
}

}  // namespace

fs::path plain_or_compressed(const fs::path& file) {
  const fs::path compressed = file.string() + ".gz";
  return !fs::exists(file) && fs::exists(compressed) ? compressed : file;
}

std::string why_not_whole(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  if (!in) return "cannot be read";
  std::string text = tail_of(in);
  if (text.empty()) return "is empty";
  if (file.extension() == ".gz") {
    const auto inflated = inflated_tail_of(file);
    if (!inflated) return "breaks off: it cannot be decompressed to its end";
    text = *inflated;
  }
  const std::size_t last = text.find_last_not_of(" \t\r\n");
  if (last == std::string::npos || last < 4 || text.compare(last - 4, 5, "** //") != 0) {
    return "breaks off: OpenFOAM's last line // *** // is missing";
  }
  return "";
}

}  // namespace powderlink::analysis
