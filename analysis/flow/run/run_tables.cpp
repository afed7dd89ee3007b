// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/flow/run/run_tables.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <fstream>
#include <sstream>

#include "analysis/flow/run/particle_dump.h"
#include "base/invalid_input.h"

namespace powderlink::analysis {

namespace fs = std::filesystem;

namespace {

[[noreturn]] void damaged_table(const fs::path& file, long line, const std::string& given) {
  throw InvalidInput(fmt::format("reading {}, line {}", file.string(), line), given,
                     "rows of numbers, as many as in the rows before",
                     "run the case again, or remove this file");
}

bool ends(std::ifstream& in) { return in.peek() == std::ifstream::traits_type::eof(); }

/// Numbers of a line; brackets and commas part them. False where something is none.
bool numbers_of(std::string line, std::vector<double>& values) {
  for (char& c : line) {
    if (c == '(' || c == ')' || c == ',') c = ' ';
  }
  values.clear();
  std::istringstream text(line);
  std::string word;
  while (text >> word) {
    double value = 0.0;
    const char* last = word.data() + word.size();
    const auto [end, error] = std::from_chars(word.data(), last, value);
    if (error != std::errc() || end != last || !std::isfinite(value)) return false;
    values.push_back(value);
  }
  return true;
}

/// By start time, then by name.
std::vector<fs::path> files_of(const fs::path& set, const std::string& stem) {
  std::vector<fs::path> files;
  std::error_code problem;
  for (const auto& [start_s, folder] : start_folders(set)) {
    const auto first = static_cast<std::ptrdiff_t>(files.size());
    for (const auto& file : fs::directory_iterator(folder, problem)) {
      const std::string own = file.path().filename().string();
      const bool is_it = own == stem + ".dat" || own.rfind(stem + "_", 0) == 0;
      if (is_it && file.path().extension() == ".dat") files.push_back(file.path());
    }
    std::sort(files.begin() + first, files.end());
  }
  return files;
}

std::vector<std::string> titles_of(const std::string& line, char mark) {
  std::vector<std::string> titles;
  std::istringstream text(line);
  std::string title;
  while (mark == ' ' ? static_cast<bool>(text >> title)
                     : static_cast<bool>(std::getline(text, title, mark))) {
    titles.push_back(title);
  }
  return titles;
}

}  // namespace

std::map<double, fs::path> start_folders(const fs::path& set) {
  std::map<double, fs::path> found;
  std::error_code problem;
  for (const auto& entry : fs::directory_iterator(set, problem)) {
    const std::string name = entry.path().filename().string();
    double time = 0.0;
    const char* last = name.data() + name.size();
    const auto [end, error] = std::from_chars(name.data(), last, time);
    if (error == std::errc() && end == last && entry.is_directory()) found[time] = entry.path();
  }
  return found;
}

std::optional<double> RunTable::mean(std::size_t column, double from_s, double to_s) const {
  double sum = 0.0;
  std::size_t count = 0;
  const auto end = rows.upper_bound(to_s);
  for (auto row = rows.upper_bound(from_s); row != end; ++row, ++count) {
    sum += row->second.at(column);
  }
  if (count == 0) return {};
  return sum / static_cast<double>(count);
}

std::optional<double> RunTable::head_number(const std::string& name) const {
  for (const std::string& line : head) {
    const std::size_t colon = line.find(':');
    if (line.find("# " + name) != 0 || colon == std::string::npos) continue;
    std::vector<double> values;
    if (numbers_of(line.substr(colon + 1), values) && values.size() == 1) return values.front();
  }
  return {};
}

RunTable read_function_object(const fs::path& folder, const std::string& function,
                              const std::string& stem) {
  RunTable table;
  std::size_t columns = 0;
  for (const fs::path& file : files_of(folder / "postProcessing" / function, stem)) {
    std::ifstream in(file);
    std::string line;
    std::vector<double> values;
    const bool first = table.head.empty();
    for (long count = 1; std::getline(in, line); ++count) {
      if (line.find_first_not_of(" \t\r") == std::string::npos) continue;
      if (line.front() == '#') {
        if (first) table.head.push_back(line);
        continue;
      }
      const bool good = numbers_of(line, values) && values.size() > 1;
      if (good && columns == 0) columns = values.size();
      if (!good || values.size() != columns) {
        if (ends(in)) break;
        damaged_table(file, count, "'" + line.substr(0, 60) + "'");
      }
      table.rows[values.front()].assign(values.begin() + 1, values.end());
    }
  }
  return table;
}

std::map<std::string, std::vector<double>> read_counts(const fs::path& folder) {
  std::map<std::string, std::vector<double>> columns;
  const fs::path file = folder / "post" / "particle_count.csv";
  std::ifstream in(file);
  std::string line;
  std::vector<std::string> titles;
  std::vector<double> values;
  for (long count = 1; std::getline(in, line); ++count) {
    if (!line.empty() && line.back() == '\r') line.pop_back();
    if (line.rfind("time_s", 0) == 0) {
      // A continued run writes it again.
      titles = titles_of(line, ',');
      continue;
    }
    if (titles.empty()) damaged_table(file, count, "no title that begins with time_s");
    if (!numbers_of(line, values) || values.size() != titles.size()) {
      if (ends(in)) break;
      damaged_table(file, count, "'" + line.substr(0, 60) + "'");
    }
    auto& times = columns["time_s"];
    // What a stopped run wrote beyond its checkpoint is written again.
    while (!times.empty() && times.back() >= values.front()) {
      for (auto& [name, column] : columns) column.pop_back();
    }
    for (std::size_t i = 0; i < titles.size(); ++i) columns[titles[i]].push_back(values[i]);
  }
  return columns;
}

std::vector<BinnedForces> read_powder_forces(const fs::path& folder) {
  std::map<long, fs::path> files;
  std::error_code problem;
  for (const auto& entry : fs::directory_iterator(folder / "post", problem)) {
    const bool is_it = entry.path().filename().string().rfind("powder_forces_", 0) == 0;
    const auto step = step_of_name(entry.path());
    if (is_it && step && entry.path().extension() == ".txt") files[*step] = entry.path();
  }
  std::map<long, BinnedForces> found;
  for (const auto& [start, file] : files) {
    std::ifstream in(file);
    std::string line;
    std::vector<std::string> titles;
    std::vector<double> values;
    const auto column = [&](const char* title, long count) {
      const auto at = std::find(titles.begin(), titles.end(), title);
      if (at == titles.end()) damaged_table(file, count, fmt::format("no column {}", title));
      return static_cast<std::size_t>(at - titles.begin());
    };
    BinnedForces state;
    std::size_t bins = 0;
    for (long count = 1; std::getline(in, line); ++count) {
      if (line.rfind("# Bin", 0) == 0) titles = titles_of(line.substr(1), ' ');
      if (line.empty() || line.front() == '#') continue;
      const bool good = numbers_of(line, values);
      if (good && values.size() == 2 && state.centre_m.size() == bins) {
        state = {};
        state.step = static_cast<long>(values[0]);
        bins = static_cast<std::size_t>(values[1]);
        continue;
      }
      if (!good || values.size() != titles.size() || bins == 0) {
        if (ends(in)) break;
        damaged_table(file, count, "'" + line.substr(0, 60) + "'");
      }
      const double particles = values[column("Ncount", count)];
      state.centre_m.push_back(values[column("Coord", count)]);
      state.wall_N.push_back(particles * values[column("v_wallForce", count)]);
      state.fluid_N.push_back(particles * values[column("v_fluidForce", count)]);
      if (state.centre_m.size() == bins) found[state.step] = state;
    }
  }
  std::vector<BinnedForces> all;
  all.reserve(found.size());
  for (auto& [step, state] : found) all.push_back(std::move(state));
  return all;
}

}  // namespace powderlink::analysis
