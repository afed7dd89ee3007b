// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/report/study_result.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "base/files/file_text.h"
#include "base/invalid_input.h"

namespace powderlink::analysis {

namespace fs = std::filesystem;

namespace {

constexpr double kSameValue = 1e-6;  // relative: both are the same fit, written with 15 digits

bool same(double a, double b) { return std::fabs(a - b) <= kSameValue * std::fabs(b); }

/// A curve over velocity alone stands for the model only if rows differ in nothing else.
bool one_curve(const Study& study) {
  return std::all_of(study.rows.begin(), study.rows.end(), [&](const KatRow& row) {
    return row.kind() == KatRow::Kind::critical_diameter &&
           row.contact_time_us == study.rows.front().contact_time_us &&
           row.adhesive_energy_J_m2 == study.rows.front().adhesive_energy_J_m2;
  });
}

}  // namespace

DemFile read_dem_file(const fs::path& file) {
  DemFile dem;
  dem.file = file;
  try {
    const auto j = nlohmann::json::parse(file_text(file));
    if (j.at("backend").get<std::string>() != "dem") {
      throw InvalidInput("--dem " + file.string(), "a comparison with the reduced model",
                         "one with LIGGGHTS",
                         "write it with: powderlink compare STUDY --backend dem --json FILE");
    }
    for (const auto& [name, value] : j.at("parameters").items())
      dem.parameters.emplace_back(name, value.get<double>());
    for (const auto& point : j.at("points")) {
      dem.velocity_m_s.push_back(point.at("impact_velocity_m_s").get<double>());
      dem.measured_um.push_back(point.at("measured").get<double>());
      dem.model_um.push_back(point.at("model").get<double>());
    }
  } catch (const nlohmann::json::exception& e) {
    throw InvalidInput("--dem " + file.string(), e.what(),
                       "a JSON file of powderlink compare --backend dem",
                       "write it with: powderlink compare STUDY --backend dem --json FILE");
  }
  return dem;
}

StudyResult::StudyResult(const fs::path& file, bool with_diagnosis)
    : study(read_study(file)),
      observations(observe(study)),
      comparison(compare(study, observations)) {
  if (!with_diagnosis) no_diagnosis = "it was not asked for";
  try {
    if (with_diagnosis) diagnosis = diagnose(study, observations);
  } catch (const InvalidInput& e) {
    no_diagnosis = e.what();
  }
  if (one_curve(study)) curve = predicted_curve(study, comparison.fit, velocities_around(study));
}

bool StudyResult::take(const DemFile& given) {
  if (given.model_um.size() != observations.list.size()) return false;
  for (std::size_t i = 0; i < observations.list.size(); ++i) {
    const Observation& o = observations.list[i];
    if (!same(given.velocity_m_s[i], o.row.impact_velocity_m_s) ||
        !same(given.measured_um[i], o.measured))
      return false;
  }
  if (given.parameters.size() != comparison.fit.parameters.size()) return false;
  for (const auto& [name, value] : given.parameters) {
    const ParameterEstimate* p = comparison.fit.find(name);
    if (p == nullptr || !same(value, p->value)) return false;
  }
  Comparison judged = comparison;
  judge(judged, study, observations, given.model_um);
  dem = DemResult{given.file, judged.model, judged.residuals, rms_relative_error(judged.rms)};
  return true;
}

std::string StudyResult::effects() const {
  std::vector<std::string> names;
  for (const EffectChoice& e : study.effects) names.push_back(e.name);
  return fmt::format("{}", fmt::join(names, " + "));
}

std::vector<const Candidate*> StudyResult::leading() const {
  std::vector<const Candidate*> list;
  if (!diagnosis) return list;
  for (const std::string& name : diagnosis->indistinguishable)
    list.push_back(&diagnosis->get(name));
  return list;
}

double StudyResult::measured_sigma(std::size_t row) const {
  const Observation& o = observations.list[row];
  return o.row.kind() == KatRow::Kind::critical_diameter ? o.measured * o.noise : o.noise;
}

}  // namespace powderlink::analysis
