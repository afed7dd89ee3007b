// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/flow/run/pressure_profile.h"

#include <fmt/format.h>

#include <algorithm>
#include <boost/math/statistics/linear_regression.hpp>
#include <charconv>
#include <cmath>
#include <fstream>
#include <limits>
#include <map>
#include <regex>
#include <sstream>

#include "analysis/flow/foam/foam_files.h"
#include "analysis/flow/run/run_tables.h"
#include "base/invalid_input.h"

namespace powderlink::analysis {

namespace fs = std::filesystem;

namespace {

constexpr double kNotFound = -1e200;  // OpenFOAM's mark for a probe outside the mesh is -1e300

[[noreturn]] void damaged_probes(const fs::path& file, long line, const std::string& given) {
  throw InvalidInput(fmt::format("reading {}, line {}", file.string(), line), given,
                     "scalar probes as OpenFOAM writes them: "
                     "# Probe N (x y z), then a time and one value per probe",
                     "run the case again, or remove this file");
}

double number(const std::string& text, const fs::path& file, long line) {
  double value = 0.0;
  const char* last = text.data() + text.size();
  const auto [end, error] = std::from_chars(text.data(), last, value);
  if (error != std::errc() || end != last || !std::isfinite(value)) {
    damaged_probes(file, line, "'" + text.substr(0, 40) + "' where a number belongs");
  }
  return value;
}

struct ProbeFile {
  std::vector<Place> places;
  std::vector<std::pair<double, std::vector<double>>> rows;  ///< time, kinematic pressures
};

/// The place that a line of the head gives.
std::optional<Place> place_in(const std::string& line, const fs::path& file, long count) {
  static const std::regex head(R"(#\s*Probe\s+\d+\s*\(\s*(\S+)\s+(\S+)\s+([^\s)]+)\s*\).*)");
  std::smatch match;
  if (!std::regex_match(line, match, head)) return {};
  return Place{number(match[1], file, count), number(match[2], file, count),
               number(match[3], file, count)};
}

std::vector<Place> read_head(const fs::path& file) {
  std::ifstream in(file);
  std::vector<Place> places;
  std::string line;
  for (long count = 1; std::getline(in, line) && line[0] == '#'; ++count) {
    if (const auto place = place_in(line, file, count)) places.push_back(*place);
  }
  return places;
}

ProbeFile read_probes(const fs::path& file) {
  std::ifstream in(file);
  ProbeFile probes;
  std::string line;
  long count = 0;
  while (std::getline(in, line)) {
    ++count;
    if (line.find_first_not_of(" \t\r") == std::string::npos) continue;
    if (line[0] == '#') {
      if (const auto place = place_in(line, file, count)) probes.places.push_back(*place);
      continue;
    }
    std::istringstream text(line);
    std::string word;
    text >> word;
    std::pair<double, std::vector<double>> row{number(word, file, count), {}};
    while (text >> word) row.second.push_back(number(word, file, count));
    if (row.second.size() != probes.places.size()) {
      // A run that was killed may leave its last line unfinished.
      if (in.peek() == std::ifstream::traits_type::eof()) break;
      damaged_probes(
          file, count,
          fmt::format("{} values for {} probes", row.second.size(), probes.places.size()));
    }
    probes.rows.push_back(std::move(row));
  }
  if (probes.places.empty()) damaged_probes(file, count, "no line # Probe N (x y z)");
  return probes;
}

/// Files of one probe set by start time.
std::map<double, fs::path> starts(const fs::path& set, const std::string& field = "p") {
  std::map<double, fs::path> found;
  for (const auto& [start_s, folder] : start_folders(set)) {
    if (fs::is_regular_file(folder / field)) found[start_s] = folder / field;
  }
  return found;
}

void require_density(const std::string& place, const std::string& text, double density_kg_m3) {
  if (density_kg_m3 > 0.0 && std::isfinite(density_kg_m3)) return;
  throw InvalidInput(place, text + " kg/m^3", "a density above 0", "correct it, such as 1.6355");
}

}  // namespace

std::optional<double> gas_density_kg_m3(const fs::path& case_folder, std::optional<double> given) {
  if (given) {
    require_density("option --density", number_text(*given), *given);
    return given;
  }
  const fs::path file = fs::path("constant") / "transportProperties";
  const auto rho = read_foam_entry(case_folder, {file, "rho"});
  if (!rho) return {};
  const double value = rho->number.value_or(std::numeric_limits<double>::quiet_NaN());
  require_density("rho in " + (case_folder / file).string(), rho->text, value);
  return value;
}

std::vector<std::string> pressure_probe_sets(const fs::path& case_folder) {
  std::vector<std::string> sets;
  std::error_code problem;
  for (const auto& entry : fs::directory_iterator(case_folder / "postProcessing", problem)) {
    if (entry.is_directory() && !starts(entry.path()).empty()) {
      sets.push_back(entry.path().filename().string());
    }
  }
  std::sort(sets.begin(), sets.end());
  return sets;
}

std::vector<Place> probe_places(const fs::path& case_folder, const std::string& set,
                                const std::string& field) {
  const auto files = starts(case_folder / "postProcessing" / set, field);
  return files.empty() ? std::vector<Place>{} : read_head(files.begin()->second);
}

PressureProfile read_pressure(const fs::path& case_folder, const std::string& set,
                              double density_kg_m3, double from_s, const FlowAxis& axis) {
  const std::map<double, fs::path> files = starts(case_folder / "postProcessing" / set);
  if (files.empty()) {
    std::string known;
    for (const std::string& name : pressure_probe_sets(case_folder)) known += " " + name;
    throw InvalidInput(
        "option --probes", set,
        known.empty() ? "no probes have recorded p in postProcessing/" : known.substr(1),
        "name one of these, or add probes of p to system/controlDict");
  }
  PressureProfile profile{set, {}, 0};
  std::vector<Place> places;
  std::vector<double> sums, weights;
  for (auto at = files.begin(); at != files.end(); ++at) {
    const auto following = std::next(at);
    const ProbeFile file = read_probes(at->second);
    if (places.empty()) {
      places = file.places;
      sums.assign(places.size(), 0.0);
      weights.assign(places.size(), 0.0);
    } else if (places != file.places) {
      damaged_probes(at->second, 1, "other probes than before the restart");
    }
    double before = at->first;
    for (const auto& [time, values] : file.rows) {
      const double dt = time - before;
      before = time;
      if (time < from_s || dt <= 0.0) continue;
      if (following != files.end() && time > following->first) break;
      ++profile.rows;
      for (std::size_t i = 0; i < values.size(); ++i) {
        if (values[i] < kNotFound) continue;
        sums[i] += dt * values[i];
        weights[i] += dt;
      }
    }
  }
  for (std::size_t i = 0; i < places.size(); ++i) {
    if (weights[i] > 0.0)
      profile.probes.push_back({axis.place_m(places[i]), density_kg_m3 * sums[i] / weights[i]});
  }
  std::sort(profile.probes.begin(), profile.probes.end(),
            [](const ProbeMean& a, const ProbeMean& b) { return a.place_m < b.place_m; });
  return profile;
}

std::optional<PressureSlope> fit_slope(const PressureProfile& profile, double from_m, double to_m,
                                       const FlowAxis& axis) {
  std::vector<double> s, p;
  for (const ProbeMean& probe : profile.probes) {
    if (probe.place_m < from_m || probe.place_m > to_m) continue;
    s.push_back(probe.place_m);
    p.push_back(probe.pressure_Pa);
  }
  if (s.size() < 2 || s.front() == s.back()) return {};
  const auto [intercept, rise, r_squared] =
      boost::math::statistics::simple_ordinary_least_squares_with_R_squared(s, p);
  return PressureSlope{intercept, -axis.way * rise, r_squared, axis.way, from_m, to_m, s.size()};
}

}  // namespace powderlink::analysis
