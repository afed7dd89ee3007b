// SPDX-License-Identifier: GPL-3.0-or-later
#include "liggghts_styles/kat_drop/kat_results.h"

#include <cmath>

#include <nlohmann/json.hpp>

#include "base/files/file_text.h"
#include "base/files/write_file.h"
#include "base/invalid_input.h"

namespace powderlink::host {

void write(const KatResults& r, const std::string& file) {
  using nlohmann::json;
  const auto or_null = [](double value) { return value > 0.0 ? json(value) : json(nullptr); };
  json grains = json::array();
  long attached = 0;
  for (const KatGrainResult& g : r.grains) {
    attached += g.attached > 0.0 ? 1 : 0;
    grains.push_back({{"id", static_cast<long>(g.id)},
                      {"diameter_m", g.diameter_m},
                      {"attached", g.attached > 0.0},
                      {"speed_m_s", g.speed_m_s},
                      {"balance", g.energy_residual},
                      {"momentum_balance", g.momentum_residual}});
  }
  const json document = {{"impact_velocity_m_s", r.impact_velocity_m_s},
                         {"critical_diameter_m", or_null(r.critical_diameter_m)},
                         {"largest_attached_m", or_null(r.largest_attached_m)},
                         {"smallest_detached_m", or_null(r.smallest_detached_m)},
                         {"attached", attached},
                         {"detached", static_cast<long>(r.grains.size()) - attached},
                         {"out_of_order", r.out_of_order},
                         {"steps", r.steps},
                         {"impact_step", r.impact_step},
                         {"time_step_s", r.time_step_s},
                         {"particles", grains}};
  write_file(file, document.dump(1) + '\n', "results file");
}

namespace {

/// 0 when the key is absent or null.
double positive(const nlohmann::json& object, const char* key, const std::filesystem::path& file) {
  if (!object.contains(key) || object[key].is_null()) return 0.0;
  const bool is_number = object[key].is_number();
  const double value = is_number ? object[key].get<double>() : 0.0;
  if (!is_number || !(value > 0.0) || !std::isfinite(value)) {
    throw InvalidInput("reading " + file.string() + ": " + key, object[key].dump(),
                       "a number above 0", "run the drop test again or correct the value");
  }
  return value;
}

}  // namespace

KatResults read_kat_results(const std::filesystem::path& file) {
  KatResults r;
  try {
    const auto j = nlohmann::json::parse(file_text(file));
    r.impact_velocity_m_s = positive(j, "impact_velocity_m_s", file);
    r.critical_diameter_m = positive(j, "critical_diameter_m", file);
    r.largest_attached_m = positive(j, "largest_attached_m", file);
    r.smallest_detached_m = positive(j, "smallest_detached_m", file);
    r.time_step_s = positive(j, "time_step_s", file);
    r.out_of_order = j.value("out_of_order", 0L);
    r.steps = j.value("steps", 0L);
    r.impact_step = j.value("impact_step", 0L);
    for (const auto& p : j.value("particles", nlohmann::json::array())) {
      const auto& attached = p.at("attached");
      const auto& speed = p.at("speed_m_s");
      r.grains.push_back(
          {p.value("id", 0.0), p.at("diameter_m").get<double>(),
           attached.is_boolean() ? double(attached.get<bool>()) : attached.get<double>(),
           speed.is_null() ? 0.0 : speed.get<double>(), p.value("balance", 0.0),
           p.value("momentum_balance", 0.0)});
    }
  } catch (const nlohmann::json::exception& error) {
    throw InvalidInput(
        "reading " + file.string(), error.what(),
        "JSON with critical_diameter_m, impact_velocity_m_s, time_step_s and particles "
        "(each with diameter_m, attached, speed_m_s)",
        "remove the folder and run again");
  }
  return r;
}

}  // namespace powderlink::host
