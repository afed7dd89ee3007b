// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/flow/run/particle_dump.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstring>
#include <fstream>
#include <string_view>

#include "base/invalid_input.h"

namespace powderlink::analysis {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t kBlock_bytes = 1 << 20;
constexpr long kMostParticles = 1'000'000'000;  // a larger count is a damaged number

/// Lines of a large file through one block of memory.
class Lines {
 public:
  explicit Lines(const fs::path& file) : in_(file, std::ios::binary), buffer_(kBlock_bytes) {
    if (!in_) {
      throw InvalidInput("reading " + file.string(), "a file that cannot be opened",
                         "a dump of LIGGGHTS that may be read", "check its name and rights");
    }
  }

  /// False at the end of the file. The line is valid until the next call.
  bool next(std::string_view& line) {
    while (true) {
      const char* start = buffer_.data() + begin_;
      if (const void* end = std::memchr(start, '\n', end_ - begin_)) {
        const auto length = static_cast<std::size_t>(static_cast<const char*>(end) - start);
        line = {start, length};
        begin_ += length + 1;
        break;
      }
      if (!fill()) {
        if (begin_ == end_) return false;
        line = {buffer_.data() + begin_, end_ - begin_};
        begin_ = end_;
        break;
      }
    }
    ++number_;
    while (!line.empty() && (line.back() == '\r' || line.back() == ' ')) line.remove_suffix(1);
    return true;
  }

  long number() const { return number_; }

 private:
  bool fill() {
    std::copy(buffer_.begin() + static_cast<std::ptrdiff_t>(begin_),
              buffer_.begin() + static_cast<std::ptrdiff_t>(end_), buffer_.begin());
    end_ -= begin_;
    begin_ = 0;
    if (end_ == buffer_.size()) buffer_.resize(2 * buffer_.size());
    in_.read(buffer_.data() + end_, static_cast<std::streamsize>(buffer_.size() - end_));
    const auto got = static_cast<std::size_t>(in_.gcount());
    end_ += got;
    return got > 0;
  }

  std::ifstream in_;
  std::vector<char> buffer_;
  std::size_t begin_ = 0, end_ = 0;
  long number_ = 0;
};

std::vector<std::string> words(std::string_view text) {
  std::vector<std::string> found;
  std::size_t at = 0;
  while ((at = text.find_first_not_of(" \t", at)) != std::string_view::npos) {
    const std::size_t end = std::min(text.find_first_of(" \t", at), text.size());
    found.emplace_back(text.substr(at, end - at));
    at = end;
  }
  return found;
}

/// Place of a column's value in DumpParticle.
constexpr std::array<std::pair<const char*, double DumpParticle::*>, 8> kNeeded{
    {{"x", &DumpParticle::x_m},
     {"y", &DumpParticle::y_m},
     {"z", &DumpParticle::z_m},
     {"vx", &DumpParticle::vx_m_s},
     {"vy", &DumpParticle::vy_m_s},
     {"vz", &DumpParticle::vz_m_s},
     {"radius", &DumpParticle::radius_m},
     {"mass", &DumpParticle::mass_kg}}};

class Reader {
 public:
  explicit Reader(const fs::path& file) : file_(file), lines_(file) {}

  bool next(DumpState& state) {
    std::string_view line;
    do {
      if (!lines_.next(line)) return false;
    } while (line.empty());
    state.time_s.reset();
    state.particles.clear();
    long count = -1;
    if (line != "ITEM: TIMESTEP") damaged("'" + short_text(line) + "' where a state begins");
    state.step = integer(get_line());
    while (true) {
      const std::string item(get_line());
      if (item.rfind("ITEM: ATOMS", 0) == 0) {
        if (count < 0) damaged("no number of atoms before the atoms");
        read_rows(item, count, state);
        return true;
      }
      if (item == "ITEM: NUMBER OF ATOMS") {
        count = integer(get_line());
        if (count < 0 || count > kMostParticles) damaged(fmt::format("{} atoms", count));
      } else if (item == "ITEM: TIME") {
        state.time_s = number(get_line());
      } else if (item.rfind("ITEM: BOX BOUNDS", 0) == 0) {
        read_box(item, state);
      } else if (item.rfind("ITEM: ", 0) == 0) {
        get_line();  // such as UNITS or LABEL
      } else {
        damaged("'" + short_text(item) + "' in the head of a state");
      }
    }
  }

 private:
  static std::string short_text(std::string_view text) { return std::string(text.substr(0, 60)); }

  [[noreturn]] void damaged(const std::string& given) const {
    throw InvalidInput(
        fmt::format("reading {}, line {}", file_.string(), lines_.number()), given,
        "complete text dumps of LIGGGHTS, dump custom with x y z vx vy vz radius mass",
        "write the dump again, or remove this file");
  }

  std::string_view get_line() {
    std::string_view line;
    if (!lines_.next(line)) damaged("a file that breaks off");
    return line;
  }

  long integer(std::string_view text) const {
    long value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc() || end != text.data() + text.size()) {
      damaged("'" + short_text(text) + "' where an integer belongs");
    }
    return value;
  }

  double number(std::string_view text) const {
    double value = 0.0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc() || end != text.data() + text.size() || !std::isfinite(value)) {
      damaged("'" + short_text(text) + "' where a number belongs");
    }
    return value;
  }

  /// `ITEM: BOX BOUNDS pp ff mm`, then low and high of each axis.
  void read_box(const std::string& item, DumpState& state) {
    const std::vector<std::string> kinds = words(item);
    for (std::size_t i = 0; i < 3; ++i) {
      state.periodic[i] = kinds.size() >= 6 && kinds[kinds.size() - 3 + i] == "pp";
      const std::vector<std::string> bounds = words(get_line());
      if (bounds.size() < 2) damaged("a side of the box without two bounds");
      state.box_low_m[i] = number(bounds[0]);
      state.box_high_m[i] = number(bounds[1]);
    }
  }

  void read_rows(const std::string& item, long count, DumpState& state) {
    const std::vector<std::string> names = words(std::string_view(item).substr(11));
    std::vector<double DumpParticle::*> targets(names.size(), nullptr);
    for (const auto& [name, member] : kNeeded) {
      const auto found = std::find(names.begin(), names.end(), name);
      if (found == names.end()) {
        damaged(fmt::format("no column {} among '{}'", name, item.substr(11)));
      }
      targets[static_cast<std::size_t>(found - names.begin())] = member;
    }
    const auto id =
        static_cast<std::size_t>(std::find(names.begin(), names.end(), "id") - names.begin());
    // Not more than a damaged count could make the program ask for at once.
    state.particles.reserve(static_cast<std::size_t>(std::min(count, 1'000'000L)));
    for (long i = 0; i < count; ++i) {
      const std::string_view line = get_line();
      DumpParticle particle;
      const char* at = line.data();
      const char* const end = at + line.size();
      for (std::size_t column = 0; column < targets.size(); ++column) {
        while (at < end && (*at == ' ' || *at == '\t')) ++at;
        const char* word_end = at;
        while (word_end < end && *word_end != ' ' && *word_end != '\t') ++word_end;
        if (at == word_end) damaged("a row with fewer values than columns");
        const std::string_view word(at, static_cast<std::size_t>(word_end - at));
        if (targets[column] != nullptr) {
          particle.*targets[column] = number(word);
        } else if (column == id) {
          particle.id = integer(word);
        }
        at = word_end;
      }
      if (at != end) damaged("a row with more values than columns");
      if (!(particle.radius_m > 0.0 && particle.mass_kg > 0.0)) {
        damaged(fmt::format("radius {:g} m, mass {:g} kg", particle.radius_m, particle.mass_kg));
      }
      state.particles.push_back(particle);
    }
  }

  fs::path file_;
  Lines lines_;
};

[[noreturn]] void nothing_in(const fs::path& dump) {
  throw InvalidInput("reading " + dump.string(), "an empty file", "complete text dumps of LIGGGHTS",
                     "write the dump again, or remove this file");
}

}  // namespace

std::optional<long> step_of_name(const fs::path& dump) {
  const std::string name = dump.stem().string();
  const std::size_t at = name.find_last_not_of("0123456789") + 1;
  long step = 0;
  const auto [end, error] = std::from_chars(name.data() + at, name.data() + name.size(), step);
  if (error != std::errc() || end != name.data() + name.size()) return {};
  return step;
}

std::vector<fs::path> list_dumps(const fs::path& case_folder) {
  const fs::path post = case_folder / "post";
  std::vector<fs::path> dumps;
  std::error_code problem;
  for (const auto& entry : fs::directory_iterator(post, problem)) {
    const std::string name = entry.path().filename().string();
    if (name.rfind("particles_", 0) == 0 && entry.path().extension() == ".dump" &&
        entry.is_regular_file()) {
      dumps.push_back(entry.path());
    }
  }
  if (dumps.empty()) {
    throw InvalidInput("looking for particles in " + post.string(),
                       problem ? problem.message() : "no file particles_*.dump",
                       "the folder of a coupled run, with post/particles_<step>.dump",
                       "give the folder in which LIGGGHTS ran, or add to its script: "
                       "dump d all custom N post/particles_*.dump "
                       "id type x y z vx vy vz radius mass");
  }
  std::sort(dumps.begin(), dumps.end(), [](const fs::path& a, const fs::path& b) {
    return std::make_pair(step_of_name(a).value_or(-1), a.string()) <
           std::make_pair(step_of_name(b).value_or(-1), b.string());
  });
  return dumps;
}

void read_dump(const fs::path& dump, const std::function<void(const DumpState&)>& use) {
  Reader reader(dump);
  DumpState state;
  if (!reader.next(state)) nothing_in(dump);
  do {
    use(state);
  } while (reader.next(state));
}

DumpState read_last_state(const fs::path& dump) {
  Reader reader(dump);
  DumpState state, last;
  if (!reader.next(state)) nothing_in(dump);
  do {
    std::swap(state, last);
  } while (reader.next(state));
  return last;
}

DumpState read_first_state(const fs::path& dump) {
  Reader reader(dump);
  DumpState state;
  if (!reader.next(state)) nothing_in(dump);
  return state;
}

}  // namespace powderlink::analysis
