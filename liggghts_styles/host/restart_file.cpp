// SPDX-License-Identifier: GPL-3.0-or-later
#include "liggghts_styles/host/restart_file.h"

#include <cmath>
#include <cstring>
#include <fstream>
#include <istream>

#include <boost/interprocess/file_mapping.hpp>
#include <boost/interprocess/mapped_region.hpp>

namespace powderlink {

namespace fs = std::filesystem;

namespace {

// Numbers of the items in the head, in the order of LIGGGHTS.
constexpr std::int32_t kVersion = 0, kUnits = 4, kStep = 5, kRanks = 7, kAtomStyle = 22,
                       kAtoms = 23;
constexpr std::int32_t kLongestText = 1000;
constexpr int kMostRanks = 1 << 20;

template <class Value>
bool read(std::istream& in, Value& value) {
  return static_cast<bool>(in.read(reinterpret_cast<char*>(&value), sizeof value));
}

bool skip_text(std::istream& in, std::string* text = nullptr) {
  std::int32_t length = 0;
  if (!read(in, length) || length < 1 || length > kLongestText) return false;
  std::string bytes(static_cast<std::size_t>(length), '\0');
  if (!in.read(bytes.data(), length)) return false;
  bytes.pop_back();
  if (text != nullptr) *text = bytes;
  return true;
}

/// A hybrid atom style names its parts.
bool skip_atom_style(std::istream& in) {
  std::string style;
  if (!skip_text(in, &style)) return false;
  std::int32_t parts = 0;
  if (style == "hybrid" && !read(in, parts)) return false;
  for (std::int32_t i = 0; i < parts; ++i) {
    if (!skip_text(in)) return false;
  }
  return true;
}

RestartHead head_of(std::istream& in) {
  RestartHead head;
  std::int32_t item = 0, value = 0;
  while (read(in, item) && item >= kVersion && item <= kAtoms) {
    if (item == kVersion || item == kUnits) {
      if (!skip_text(in)) return head;
    } else if (item == kAtomStyle) {
      if (!skip_atom_style(in)) return head;
    } else if (item == kStep || item == kAtoms) {
      std::int64_t number = 0;
      if (!read(in, number)) return head;
      (item == kStep ? head.step : head.atoms) = number;
    } else {
      if (!read(in, value)) return head;
      if (item == kRanks) head.ranks = value;
    }
  }
  return head;
}

class Bytes {
 public:
  explicit Bytes(const fs::path& file)
      : mapping_(file.c_str(), boost::interprocess::read_only),
        region_(mapping_, boost::interprocess::read_only) {}
  std::size_t size() const { return region_.get_size(); }
  template <class Value>
  Value at(std::size_t place) const {
    Value value;
    std::memcpy(&value, static_cast<const char*>(region_.get_address()) + place, sizeof value);
    return value;
  }

 private:
  boost::interprocess::file_mapping mapping_;
  boost::interprocess::mapped_region region_;
};

/// Where the block of a rank that begins at `place` ends, or nothing; counts its atoms.
std::optional<std::size_t> end_of_block(const Bytes& bytes, std::size_t place,
                                        std::int64_t& atoms) {
  if (bytes.size() - place < sizeof(std::int32_t)) return {};
  const auto doubles = bytes.at<std::int32_t>(place);
  const std::size_t first = place + sizeof(std::int32_t);
  if (doubles < 0 || static_cast<std::size_t>(doubles) > (bytes.size() - first) / sizeof(double)) {
    return {};
  }
  for (std::int32_t at = 0; at < doubles;) {
    const auto length = bytes.at<double>(first + static_cast<std::size_t>(at) * sizeof(double));
    if (!(length >= 1.0 && length <= doubles - at) || length != std::floor(length)) return {};
    at += static_cast<std::int32_t>(length);
    ++atoms;
  }
  return first + static_cast<std::size_t>(doubles) * sizeof(double);
}

bool ends_with_blocks(const Bytes& bytes, int ranks, std::int64_t expected) {
  for (std::size_t begin = 0; begin < bytes.size(); ++begin) {
    std::int64_t atoms = 0;
    std::optional<std::size_t> place = begin;
    for (int rank = 0; rank < ranks && place; ++rank) place = end_of_block(bytes, *place, atoms);
    if (place && *place == bytes.size() && atoms == expected) return true;
  }
  return false;
}

fs::path file_of_rank(const fs::path& pattern, const std::string& rank) {
  std::string name = pattern.string();
  name.replace(name.find('%'), 1, rank);
  return name;
}

std::string why_unreadable(const fs::path& file) {
  std::error_code problem;
  if (!fs::exists(file, problem)) return " is missing";
  if (!fs::is_regular_file(file, problem)) return " is no file";
  if (!std::ifstream(file)) return " cannot be read";
  return fs::file_size(file, problem) == 0 ? " is empty" : "";
}

std::string why_not_whole_single(const fs::path& file, const RestartHead& head) {
  return ends_with_blocks(Bytes(file), *head.ranks, *head.atoms)
             ? ""
             : file.string() + " breaks off: the atoms of its " + std::to_string(*head.ranks) +
                   " rank(s) are not all there";
}

std::string why_not_whole_ranks(const fs::path& pattern, const RestartHead& head) {
  std::int64_t atoms = 0;
  for (int rank = 0; rank < *head.ranks; ++rank) {
    const fs::path file = file_of_rank(pattern, std::to_string(rank));
    const std::string wrong = why_unreadable(file);
    if (!wrong.empty()) return file.string() + wrong;
    const Bytes bytes(file);
    const auto end = end_of_block(bytes, 0, atoms);
    if (!end || *end != bytes.size()) return file.string() + " breaks off";
  }
  if (atoms == *head.atoms) return "";
  return pattern.string() + " has " + std::to_string(atoms) + " atoms in the files of its ranks, " +
         std::to_string(*head.atoms) + " in its head";
}

}  // namespace

RestartHead read_restart_head(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  return head_of(in);
}

std::string why_not_whole_restart(const fs::path& file) {
  const bool single = file.string().find('%') == std::string::npos;
  const fs::path with_head = single ? file : file_of_rank(file, "base");
  const std::string wrong = why_unreadable(with_head);
  if (!wrong.empty()) return with_head.string() + wrong;
  const RestartHead head = read_restart_head(with_head);
  // LIGGGHTS writes the number of atoms always; without it zeros of a cut head look like ranks without atoms.
  if (!head.step || !head.atoms || !head.ranks || *head.ranks < 1 || *head.ranks > kMostRanks) {
    return with_head.string() + " is not a restart file of LIGGGHTS, or breaks off";
  }
  return single ? why_not_whole_single(file, head) : why_not_whole_ranks(file, head);
}

}  // namespace powderlink
