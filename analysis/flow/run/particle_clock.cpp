// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/flow/run/particle_clock.h"

#include <algorithm>
#include <charconv>
#include <cmath>

#include <fmt/format.h>

#include "analysis/flow/foam/foam_files.h"
#include "analysis/flow/run/dem_time_step.h"

namespace powderlink::analysis {

namespace fs = std::filesystem;

namespace {

constexpr double kTimeRounding = 1e-9;  // of a time: names of folders and sums of steps are rounded

std::optional<double> time_of_name(const std::string& name) {
  double time = 0.0;
  const char* last = name.data() + name.size();
  const auto [end, error] = std::from_chars(name.data(), last, time);
  if (error != std::errc() || end != last) return {};
  return time;
}

/// `time_s` without the round-off of times as long as `scale_s`: 13000 steps of 1 us less 3 ms are the 0.01 s
/// that a user writes, and not before them.
double without_round_off(double time_s, double scale_s) {
  if (!(std::abs(scale_s) > 0.0) || !std::isfinite(scale_s)) return time_s;
  constexpr int digits = 12;
  const int decimals = digits - static_cast<int>(std::floor(std::log10(std::abs(scale_s))));
  const std::string text = fmt::format("{:.{}f}", time_s, std::max(decimals, 0));
  return time_of_name(text).value_or(time_s);
}

std::string unquoted(const std::string& text) {
  const bool quoted = text.size() >= 2 && text.front() == '"' && text.back() == '"';
  return quoted ? text.substr(1, text.size() - 2) : text;
}

std::vector<std::string> time_folders(const fs::path& root) {
  std::vector<std::string> names;
  std::error_code problem;
  for (const auto& entry : fs::directory_iterator(root, problem)) {
    std::string name = entry.path().filename().string();
    if (entry.is_directory() && time_of_name(name)) names.push_back(std::move(name));
  }
  return names;
}

}  // namespace

std::map<std::string, WrittenClock> read_written_clocks(const fs::path& case_folder,
                                                        const fs::path& root,
                                                        const std::vector<std::string>& names) {
  std::vector<FoamQuestion> questions;
  for (const std::string& name : names) {
    const fs::path uniform = fs::absolute(root) / name / "uniform";
    questions.push_back({uniform / "time", "value"});
    questions.push_back({uniform / "couplingClock", "particlesAhead"});
    questions.push_back({uniform / "couplingClock", "files"});
  }
  const auto answers = read_foam_entries(case_folder, questions, UnreadableFile::left_out);
  std::map<std::string, WrittenClock> clocks;
  for (std::size_t i = 0; i < names.size(); ++i) {
    const auto& time = answers[3 * i];
    const auto& ahead = answers[3 * i + 1];
    const auto& files = answers[3 * i + 2];
    if (!time && !ahead && !files) continue;
    WrittenClock& clock = clocks[names[i]];
    if (time) clock.time_s = time->number;
    clock.has_ahead = ahead && ahead->number;
    if (clock.has_ahead) clock.particles_ahead_s = *ahead->number;
    if (files) clock.files = unquoted(files->text);
  }
  return clocks;
}

ParticleClock::ParticleClock(const fs::path& case_folder, std::optional<double> time_step_s)
    : folder_(case_folder), given_step_s_(time_step_s) {
  for (const fs::path& root : {case_folder, case_folder / "processor0"}) {
    for (const auto& [name, clock] : read_written_clocks(folder_, root, time_folders(root))) {
      if (!clock.has_ahead) continue;
      const double time_s = clock.time_s.value_or(*time_of_name(name));
      ahead_[time_s + clock.particles_ahead_s] = clock.particles_ahead_s;
    }
  }
}

double ParticleClock::on_gas_clock(double particles_s) const {
  if (ahead_.empty()) return without_round_off(particles_s, particles_s);
  const auto next = ahead_.lower_bound(particles_s * (1.0 - kTimeRounding));
  const double ahead_s = next == ahead_.end() ? ahead_.rbegin()->second : next->second;
  return without_round_off(particles_s - ahead_s,
                           std::max(std::abs(particles_s), std::abs(ahead_s)));
}

double ParticleClock::gas_time_s(const DumpState& state) {
  return state.time_s ? on_gas_clock(*state.time_s) : gas_time_s(state.step);
}

double ParticleClock::gas_time_s(long step) {
  if (!step_s_) step_s_ = dem_time_step_s(folder_, given_step_s_);
  return on_gas_clock(static_cast<double>(step) * *step_s_);
}

}  // namespace powderlink::analysis
