// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/kat/dem/kat_output.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "base/text/text_table.h"

namespace powderlink::analysis {

namespace {

std::string percent(double value, double reference) {
  return fmt::format("{:+.2f} %", 100.0 * (value / reference - 1.0));
}

std::string or_empty(const std::optional<double>& value) {
  return value ? fmt::format("{:g}", *value) : "";
}

}  // namespace

std::string kat_table(const std::vector<KatPoint>& points) {
  TextTable t({"v [m/s]", "Gamma [J/m^2]", "closed form [um]", "limit", "reduced [um]",
               "LIGGGHTS d_c [um]", "measured [um]", "LIGGGHTS - closed form", "- reduced",
               "- measured"});
  for (const KatPoint& p : points) {
    const double d = p.dem.critical_diameter_m * 1e6;
    t.add({fmt::format("{:g}", p.row.impact_velocity_m_s),
           fmt::format("{:.4g}", p.adhesive_energy_J_m2),
           fmt::format("{:.2f}", p.theory.diameter_m * 1e6), p.theory.limit, p.reduced.text_um(),
           fmt::format("{:.2f}", d), or_empty(p.row.critical_diameter_um),
           percent(d, p.theory.diameter_m * 1e6),
           p.reduced.found() ? percent(d, p.reduced.diameter_m * 1e6) : "",
           p.row.critical_diameter_um ? percent(d, *p.row.critical_diameter_um) : ""});
  }
  return t.text();
}

std::string kat_json(const std::vector<KatPoint>& points) {
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  const auto or_null = [](const std::optional<double>& value) {
    return value ? nlohmann::ordered_json(*value) : nlohmann::ordered_json(nullptr);
  };
  for (const KatPoint& p : points) {
    list.push_back(
        {{"impact_velocity_m_s", p.row.impact_velocity_m_s},
         {"critical_diameter_um", p.dem.critical_diameter_m * 1e6},
         {"theory_um", p.theory.diameter_m * 1e6},
         {"attached", p.dem.attached},
         {"detached", p.dem.detached},
         {"wall_s", p.dem.wall_s},
         {"theory_limit", p.theory.limit},
         {"reduced_um", p.reduced.found() ? nlohmann::ordered_json(p.reduced.diameter_m * 1e6)
                                          : nlohmann::ordered_json(nullptr)},
         {"measured_um", or_null(p.row.critical_diameter_um)},
         {"adhesive_energy_J_m2", p.adhesive_energy_J_m2},
         {"largest_attached_um", p.dem.largest_attached_m * 1e6},
         {"smallest_detached_um", p.dem.smallest_detached_m * 1e6},
         {"rounds", p.dem.rounds},
         {"energy_balance", p.dem.largest_balance}});
  }
  return nlohmann::ordered_json{{"points", list}}.dump(1) + "\n";
}

std::string kat_csv(const std::string& study_name, const std::vector<KatPoint>& points) {
  std::string text =
      "# " + study_name + ": critical diameters; empty cells were not measured\n" +
      "impact_velocity_m_s,adhesive_energy_J_m2,theory_um,reduced_um,critical_diameter_um,"
      "largest_attached_um,smallest_detached_um,measured_um,measured_sigma_um\n";
  for (const KatPoint& p : points) {
    text +=
        fmt::format("{:g},{:.6g},{:.6g},{},{:.6g},{:.6g},{:.6g},{},{}\n", p.row.impact_velocity_m_s,
                    p.adhesive_energy_J_m2, p.theory.diameter_m * 1e6,
                    p.reduced.found() ? fmt::format("{:.6g}", p.reduced.diameter_m * 1e6) : "",
                    p.dem.critical_diameter_m * 1e6, p.dem.largest_attached_m * 1e6,
                    p.dem.smallest_detached_m * 1e6, or_empty(p.row.critical_diameter_um),
                    or_empty(p.row.critical_diameter_sigma_um));
  }
  return text;
}

std::string particles_csv(const std::string& study_name, const std::vector<KatPoint>& points) {
  std::string text = "# " + study_name +
                     ": every particle of every run; speed away from the plate\n" +
                     "impact_velocity_m_s,diameter_um,attached,speed_m_s,energy_balance\n";
  for (const KatPoint& p : points) {
    for (const DropParticle& g : p.dem.particles) {
      text += fmt::format("{:g},{:.8g},{},{:.6g},{:.3g}\n", p.row.impact_velocity_m_s,
                          g.diameter_m * 1e6, g.attached ? 1 : 0, g.speed_m_s, g.balance);
    }
  }
  return text;
}

}  // namespace powderlink::analysis
