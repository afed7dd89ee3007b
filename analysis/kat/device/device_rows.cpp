// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/kat/device/device_rows.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <map>

#include "analysis/kat/study/checks.h"
#include "analysis/kat/study/study_material.h"
#include "base/invalid_input.h"
#include "base/text/text_table.h"
#include "base/toml/toml_text.h"

namespace powderlink::analysis {

namespace {

void require_one_per_drop(const std::string& option, std::size_t given, std::size_t drops,
                          bool one_for_all) {
  if (given == 0 || given == drops || (one_for_all && given == 1)) return;
  throw InvalidInput(option, fmt::format("{} values", given),
                     fmt::format("{} (one per drop without fault)", drops),
                     "give them in the order of the drops");
}

std::string report_of(const kat::Drop& drop) {
  std::string text;
  for (uint8_t i = 0; i < drop.lines(); ++i) text += kat::drop_line(drop, i).finish();
  return text;
}

/// Every drop once: the device sends its report by itself and again when asked, and a log may be
/// given together with its copy. All fields agree then, times since release to the microsecond.
std::vector<LoggedDrop> each_once(const std::vector<LoggedDrop>& drops,
                                  std::vector<std::string>& notes) {
  std::map<std::string, std::string> places;  // by the whole report
  std::vector<LoggedDrop> once;
  for (const LoggedDrop& logged : drops) {
    const auto [known, is_new] = places.emplace(report_of(logged.drop), logged.place);
    if (is_new) {
      once.push_back(logged);
    } else {
      notes.push_back(fmt::format("{}: the same report of drop {} as {}, counted once",
                                  logged.place, logged.drop.number, known->second));
    }
  }
  return once;
}

std::string cell(const std::optional<double>& value, const char* format) {
  return value ? fmt::format(fmt::runtime(format), *value) : "-";
}

}  // namespace

DeviceRows device_rows(const std::vector<LoggedDrop>& drops, const DeviceSigmas& sigmas,
                       const std::vector<double>& diameters_um,
                       const std::vector<double>& sigmas_um) {
  DeviceRows result;
  for (const LoggedDrop& logged : each_once(drops, result.notes)) {
    const kat::Drop& drop = logged.drop;
    if (drop.fault != kat::Code::none) {
      result.notes.push_back(fmt::format("{}: drop {} ended in {} ({}), left out; to do: {}",
                                         logged.place, drop.number, kat::state_name(drop.state),
                                         kat::code_name(drop.fault), kat::code_advice(drop.fault)));
      continue;
    }
    DeviceRow row{logged, device_velocity(drop, sigmas, logged.place)};
    require_velocity_m_s(row.velocity.value_m_s, logged.place);
    if (drop.contacts.kept() > 0 && drop.contacts[0].duration_us != kat::kNoValue)
      row.contact_time_us = require_contact_time_us(drop.contacts[0].duration_us, logged.place);
    if (!row.velocity.consistent) {
      result.notes.push_back(
          fmt::format("{}: drop {}: {:.4g} m/s by the beam, {:.4g} m/s by the flight to the anvil: "
                      "check carrier_um, beam_um, latency_us and friction of the guide",
                      logged.place, drop.number, row.velocity.value_m_s, *row.velocity.flight_m_s));
    }
    result.rows.push_back(row);
  }
  const std::size_t n = result.rows.size();
  if (diameters_um.empty() && !sigmas_um.empty()) {
    throw InvalidInput("--critical-diameter-sigma", "deviations without diameters",
                       "both options, or neither", "give --critical-diameter too");
  }
  require_one_per_drop("--critical-diameter", diameters_um.size(), n, false);
  require_one_per_drop("--critical-diameter-sigma", sigmas_um.size(), n, true);
  for (std::size_t i = 0; i < n && !diameters_um.empty(); ++i) {
    result.rows[i].critical_diameter_um =
        require_diameter_um(diameters_um[i], "--critical-diameter");
    if (!sigmas_um.empty())
      result.rows[i].critical_diameter_sigma_um =
          sigmas_um.size() == 1 ? sigmas_um[0] : sigmas_um[i];
  }
  return result;
}

std::string device_table(const std::vector<DeviceRow>& rows) {
  TextTable table({"drop", "v [m/s]", "+- [m/s]", "by flight [m/s]", "contact [us]", "contacts",
                   "switch lag [us]", "switches", "peak [g]"});
  for (const DeviceRow& row : rows) {
    const kat::Drop& d = row.source.drop;
    const auto optional = [](uint32_t value, double scale) {
      return value == kat::kNoValue ? std::nullopt : std::optional<double>(value * scale);
    };
    std::optional<double> lag;
    if (d.vibration_us != kat::kNoValue) lag = static_cast<int32_t>(d.vibration_us - d.touch_us);
    table.add({std::to_string(d.number), fmt::format("{:.4f}", row.velocity.value_m_s),
               fmt::format("{:.4f}", row.velocity.sigma_m_s),
               cell(row.velocity.flight_m_s, "{:.4f}"), cell(row.contact_time_us, "{:.0f}"),
               std::to_string(d.contacts.total()), cell(lag, "{:.0f}"),
               cell(optional(d.switches, 1.0), "{:.0f}"),
               cell(optional(d.peak_mg, 1e-3), "{:.1f}")});
  }
  return table.text();
}

std::string device_csv(const std::vector<DeviceRow>& rows) {
  // A column is there when all rows have it: a study takes no empty cells.
  bool diameters = !rows.empty(), sigmas = !rows.empty(), contacts = !rows.empty();
  for (const DeviceRow& row : rows) {
    diameters = diameters && row.critical_diameter_um.has_value();
    sigmas = sigmas && row.critical_diameter_sigma_um.has_value();
    contacts = contacts && row.contact_time_us.has_value();
  }
  std::string text = "# Drops of the KAT device; velocity by the beam and gravity.\n";
  for (const DeviceRow& row : rows) text += "# " + quoted(row.source.place) + "\n";
  text += "impact_velocity_m_s";
  if (diameters) text += ",critical_diameter_um";
  if (sigmas) text += ",critical_diameter_sigma_um";
  if (contacts) text += ",contact_time_us";
  text += ",impact_velocity_sigma_m_s,drop\n";
  for (const DeviceRow& row : rows) {
    text += fmt::format("{:.6g}", row.velocity.value_m_s);
    if (diameters) text += fmt::format(",{:g}", *row.critical_diameter_um);
    if (sigmas) text += fmt::format(",{:g}", *row.critical_diameter_sigma_um);
    if (contacts) text += fmt::format(",{:g}", *row.contact_time_us);
    text += fmt::format(",{:.3g},{}\n", row.velocity.sigma_m_s, row.source.drop.number);
  }
  return text;
}

std::string device_study(const std::vector<DeviceRow>& rows, const std::string& name,
                         const std::string& csv, const physics::Material& particle,
                         const physics::Material& substrate) {
  const bool measured = !rows.empty() && rows.front().critical_diameter_um.has_value();
  std::string text = fmt::format(
      "# Drops of the KAT device.\n[study]\nname = {}\nexperiment = "
      "\"kat_critical_diameter\"\n",
      quoted(name));
  if (measured) text += fmt::format("measurements = {}\n", quoted(csv));
  text += material_text("particle", particle) + material_text("substrate", substrate);
  text +=
      "\n[model]\neffects = [\"finite_stop_pulse\"]  # contact_time_us of the table is its tau_s\n";
  if (measured) return text + "\n[fit]\nadhesive_energy_J_m2 = [0.001, 1000.0]\n";
  std::vector<std::string> velocities;
  velocities.reserve(rows.size());
  for (const DeviceRow& row : rows)
    velocities.push_back(fmt::format("{:.6g}", row.velocity.value_m_s));
  return text + fmt::format(
                    "\n[fit]\nadhesive_energy_J_m2 = 0.1  # no diameters: a guess of yours\n"
                    "\n[kat]\nvelocities_m_s = [{}]\n",
                    fmt::join(velocities, ", "));
}

}  // namespace powderlink::analysis
