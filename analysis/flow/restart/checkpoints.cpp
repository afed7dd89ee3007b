// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/flow/restart/checkpoints.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <map>
#include <set>
#include <sstream>

#include "analysis/flow/restart/field_file.h"
#include "analysis/flow/run/dem_time_step.h"
#include "analysis/flow/run/particle_clock.h"
#include "base/invalid_input.h"
#include "liggghts_styles/host/restart_file.h"

namespace powderlink::analysis {

namespace fs = std::filesystem;

namespace {

constexpr std::array<const char*, 4> kFields{"U", "p", "phi", "alphaf"};
constexpr const char* kBalance = "momentumBalance";
constexpr const char* kClock = "uniform/couplingClock";
constexpr double kDigits = 6.0;         // OpenFOAM's default timePrecision
constexpr std::size_t kMostLines = 10;  // of reasons in one message

template <class Number>
std::optional<Number> whole_number(const std::string& text) {
  Number value{};
  const char* last = text.data() + text.size();
  const auto [end, error] = std::from_chars(text.data(), last, value);
  if (error != std::errc() || end != last) return {};
  return value;
}

/// How far a time may be from the name that OpenFOAM made of it: half a unit of the last
/// significant digit, of which there are kDigits, or as many as the name shows.
double rounding_of(const std::string& name, double time_s) {
  if (time_s == 0.0) return 0.0;
  const std::string number = name.substr(0, name.find_first_of("eE"));
  const auto first =
      std::find_if(number.begin(), number.end(), [](char c) { return c >= '1' && c <= '9'; });
  const auto shown = std::count_if(first, number.end(), [](char c) { return c != '.'; });
  const double digits = std::max(kDigits, static_cast<double>(shown));
  return 0.5 * std::pow(10.0, std::floor(std::log10(std::abs(time_s))) + 1.0 - digits);
}

/// Field files in a time folder, without the ending .gz.
std::map<std::string, fs::path> files_of(const fs::path& folder) {
  std::map<std::string, fs::path> files;
  std::error_code problem;
  for (const auto& entry : fs::directory_iterator(folder, problem)) {
    if (!entry.is_regular_file()) continue;
    const fs::path& file = entry.path();
    files[(file.extension() == ".gz" ? file.stem() : file.filename()).string()] = file;
  }
  return files;
}

/// Names of the files that belong to the checkpoint, relative to its folders: those that every one must
/// have, those that any processor has, and those that powderFoam says it has written.
std::set<std::string> wanted_files(const FieldCheckpoint& checkpoint, const std::string& written) {
  std::set<std::string> wanted(kFields.begin(), kFields.end());
  bool has_clock = false;
  for (const fs::path& folder : checkpoint.folders) {
    for (const auto& [name, file] : files_of(folder)) wanted.insert(name);
    has_clock = has_clock || fs::exists(plain_or_compressed(folder / kClock));
  }
  if (has_clock) {
    // Releases that do not name the files have written this one all the same.
    std::istringstream names(written.empty() ? kBalance : written);
    for (std::string name; names >> name;) wanted.insert(name);
  }
  if (has_clock || wanted.count(kBalance) > 0) wanted.insert(kClock);
  return wanted;
}

void judge(FieldCheckpoint& checkpoint, const std::string& written) {
  const std::set<std::string> wanted = wanted_files(checkpoint, written);
  checkpoint.of_coupled_run = wanted.count(kClock) > 0;
  for (const fs::path& folder : checkpoint.folders) {
    for (const std::string& name : wanted) {
      const fs::path file = plain_or_compressed(folder / name);
      const std::string wrong = fs::exists(file) ? why_not_whole(file) : "is missing";
      if (!wrong.empty()) {
        checkpoint.missing = (folder / name).string() + " " + wrong;
        return;
      }
    }
  }
}

/// Of the case's folder, or of all processors.
std::vector<FieldCheckpoint> find_fields_in(const fs::path& case_folder,
                                            const std::vector<fs::path>& roots, bool decomposed) {
  std::set<std::string> names;
  for (const fs::path& root : roots) {
    for (const auto& entry : fs::directory_iterator(root)) {
      const std::string name = entry.path().filename().string();
      if (entry.is_directory() && whole_number<double>(name)) names.insert(name);
    }
  }
  const auto clocks = read_written_clocks(case_folder, roots.front(), {names.begin(), names.end()});
  std::vector<FieldCheckpoint> found;
  for (const std::string& name : names) {
    FieldCheckpoint checkpoint;
    checkpoint.name = name;
    checkpoint.decomposed = decomposed;
    checkpoint.time_s = *whole_number<double>(name);
    checkpoint.rounding_s = rounding_of(name, checkpoint.time_s);
    for (const fs::path& root : roots) checkpoint.folders.push_back(root / name);
    WrittenClock clock;
    if (const auto written = clocks.find(name); written != clocks.end()) clock = written->second;
    if (clock.time_s) {
      checkpoint.time_s = *clock.time_s;
      checkpoint.rounding_s = 0.0;
    }
    checkpoint.particles_ahead_s = clock.particles_ahead_s;
    judge(checkpoint, clock.files);
    found.push_back(std::move(checkpoint));
  }
  std::sort(found.begin(), found.end(),
            [](const FieldCheckpoint& a, const FieldCheckpoint& b) { return a.time_s < b.time_s; });
  // From the first time of a coupled run on all are of one: where nothing says so any more, that is lost.
  bool coupled = false;
  for (FieldCheckpoint& checkpoint : found) {
    coupled = coupled || checkpoint.of_coupled_run;
    if (coupled && !checkpoint.of_coupled_run && checkpoint.missing.empty()) {
      checkpoint.missing = (checkpoint.folders.front() / kClock).string() + " is missing";
    }
  }
  return found;
}

std::vector<fs::path> processors_of(const fs::path& case_folder) {
  std::vector<fs::path> roots;
  for (const auto& entry : fs::directory_iterator(case_folder)) {
    const std::string name = entry.path().filename().string();
    if (entry.is_directory() && name.rfind("processor", 0) == 0 &&
        whole_number<int>(name.substr(9))) {
      roots.push_back(entry.path());
    }
  }
  std::sort(roots.begin(), roots.end(), [](const fs::path& a, const fs::path& b) {
    return whole_number<int>(a.filename().string().substr(9)) <
           whole_number<int>(b.filename().string().substr(9));
  });
  return roots;
}

/// Those of the processors, and those of the case itself that are newer: a run on one rank has written
/// them, and left the processors behind. Older ones reconstructPar has made, or are where a run began.
std::vector<FieldCheckpoint> find_fields(const fs::path& case_folder) {
  std::vector<FieldCheckpoint> serial = find_fields_in(case_folder, {case_folder}, false);
  const std::vector<fs::path> processors = processors_of(case_folder);
  if (processors.empty()) return serial;
  std::vector<FieldCheckpoint> all = find_fields_in(case_folder, processors, true);
  const double newest = all.empty() ? -1.0 : all.back().time_s;
  for (FieldCheckpoint& one : serial) {
    if (one.time_s > newest) all.push_back(std::move(one));
  }
  return all;
}

std::vector<DemCheckpoint> find_dem(const fs::path& case_folder, const std::string& prefix) {
  std::vector<DemCheckpoint> found;
  std::error_code problem;
  const fs::path place = case_folder / prefix;
  const std::string begin = place.filename().string();
  for (const auto& entry : fs::directory_iterator(place.parent_path(), problem)) {
    const std::string name = entry.path().filename().string();
    if (name.rfind(begin, 0) != 0 || !entry.is_regular_file()) continue;
    const auto step = whole_number<long>(name.substr(begin.size()));
    if (!step) continue;  // the link restart.latest, or a file still being written
    DemCheckpoint checkpoint{*step, entry.path(), ""};
    const auto inside = read_restart_head(entry.path()).step;
    if (entry.file_size() == 0) {
      checkpoint.missing = checkpoint.file.string() + " is empty";
    } else if (!inside) {
      checkpoint.missing =
          checkpoint.file.string() + " is not a restart file of LIGGGHTS, or breaks off";
    } else if (*inside != *step) {
      checkpoint.missing = fmt::format("{} holds step {}", checkpoint.file.string(), *inside);
    }
    found.push_back(std::move(checkpoint));
  }
  std::sort(found.begin(), found.end(),
            [](const DemCheckpoint& a, const DemCheckpoint& b) { return a.step < b.step; });
  return found;
}

double particles_time_s(const FieldCheckpoint& fields) {
  return fields.time_s + fields.particles_ahead_s;
}

double apart_s(const FieldCheckpoint& fields, const DemCheckpoint& dem, double dt_s) {
  return std::abs(particles_time_s(fields) - static_cast<double>(dem.step) * dt_s);
}

bool same_time(const FieldCheckpoint& fields, const DemCheckpoint& dem, double dt_s) {
  return apart_s(fields, dem, dt_s) < std::max(0.5 * dt_s, fields.rounding_s);
}

/// The step closest to the fields' time, if it is that time.
const DemCheckpoint* partner(const FieldCheckpoint& fields, const std::vector<DemCheckpoint>& dem,
                             double dt_s) {
  const DemCheckpoint* best = nullptr;
  const auto apart = [&](const DemCheckpoint& d) { return apart_s(fields, d, dt_s); };
  for (const DemCheckpoint& d : dem) {
    if (same_time(fields, d, dt_s) && (best == nullptr || apart(d) < apart(*best))) best = &d;
  }
  return best;
}

}  // namespace

Checkpoints find_checkpoints(const fs::path& case_folder, std::optional<double> time_step_s,
                             const std::string& dem_prefix) {
  if (!fs::is_directory(case_folder)) {
    throw InvalidInput("opening the case", case_folder.string(), "the folder of a coupled case",
                       "correct the path");
  }
  Checkpoints found;
  found.time_step_s = dem_time_step_s(case_folder, time_step_s);
  found.dem_prefix = dem_prefix;
  found.fields = find_fields(case_folder);
  found.dem = find_dem(case_folder, dem_prefix);
  for (auto fields = found.fields.rbegin(); fields != found.fields.rend() && !found.last;
       ++fields) {
    const DemCheckpoint* same = partner(*fields, found.dem, found.time_step_s);
    if (!fields->missing.empty() || same == nullptr) continue;
    DemCheckpoint& dem = found.dem[static_cast<std::size_t>(same - found.dem.data())];
    // As long as the file: only of those that may be of use.
    if (dem.missing.empty()) dem.missing = why_not_whole_restart(dem.file);
    if (dem.missing.empty()) found.last = CheckpointPair{*fields, dem};
  }
  return found;
}

std::vector<std::string> Checkpoints::refused() const {
  std::vector<std::pair<double, std::string>> reasons;
  const double after = last ? last->fields.time_s : -1.0;
  for (const FieldCheckpoint& f : fields) {
    if (f.time_s <= after) continue;
    const DemCheckpoint* d = partner(f, dem, time_step_s);
    std::string why = f.missing;
    if (why.empty() && d == nullptr) {
      why = fmt::format("no {}{:.0f} beside it", dem_prefix, particles_time_s(f) / time_step_s);
    } else if (why.empty()) {
      why = d->missing;
    }
    reasons.emplace_back(f.time_s, fmt::format("fields of time {}: {}", f.name, why));
  }
  for (const DemCheckpoint& d : dem) {
    const double time_s = static_cast<double>(d.step) * time_step_s;
    if (last && d.step <= last->dem.step) continue;
    const bool paired = std::any_of(fields.begin(), fields.end(), [&](const FieldCheckpoint& f) {
      return same_time(f, d, time_step_s);
    });
    if (!paired) {
      reasons.emplace_back(time_s, fmt::format("{}: no fields of time {:g} s beside it",
                                               d.file.filename().string(), time_s));
    }
  }
  std::stable_sort(reasons.begin(), reasons.end(),
                   [](const auto& a, const auto& b) { return a.first > b.first; });
  std::vector<std::string> lines;
  lines.reserve(reasons.size());
  for (auto& reason : reasons) lines.push_back(std::move(reason.second));
  return lines;
}

std::string Checkpoints::stale_processors() const {
  if (!last || last->fields.decomposed) return "";
  const FieldCheckpoint* stale = nullptr;
  for (const FieldCheckpoint& f : fields) {
    if (f.decomposed) stale = &f;
  }
  if (stale == nullptr) return "";
  return fmt::format(
      "the fields are those of the case's folder; "
      "the {} processor folder(s) beside it end at time {}: "
      "a run with -parallel would start from there; "
      "decompose anew before one: decomposePar -force -latestTime",
      stale->folders.size(), stale->name);
}

Checkpoints require_checkpoints(const fs::path& case_folder, std::optional<double> time_step_s,
                                const std::string& dem_prefix) {
  Checkpoints found = find_checkpoints(case_folder, time_step_s, dem_prefix);
  if (!found.last) {
    std::string given;
    const auto lines = found.refused();
    for (std::size_t i = 0; i < std::min(lines.size(), kMostLines); ++i) {
      given += (i > 0 ? "; " : "") + lines[i];
    }
    throw InvalidInput(
        "looking for a complete pair of checkpoints in " + case_folder.string(),
        given.empty() ? "no time folder and no " + dem_prefix + "<step>" : given,
        "time folders with U, p, phi and alphaf of every processor and the " + dem_prefix +
            "<step> of the same time",
        "give --checkpoint PREFIX if fix couple/bridge has the keyword checkpoint; "
        "else start the run from the beginning, and let both codes write at the same times");
  }
  return found;
}

}  // namespace powderlink::analysis
