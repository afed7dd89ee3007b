// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/kat/experiment/kat_analysis_output.h"

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "analysis/kat/experiment/methods/contact_radius.h"
#include "base/text/text_table.h"

namespace powderlink::analysis {

namespace {

using Json = nlohmann::ordered_json;

Json interval(const Estimate& e) { return {{"value", e.value}, {"low", e.low}, {"high", e.high}}; }

Json retention_json(const RetentionAnalysis& r) {
  Json j;
  j["shape"] = r.smeared ? "smeared" : "ideal truncation";
  j["why"] = r.decision();
  j["evidence_of_width"] = r.evidence;
  j["width_percent"] = 100.0 * r.fit().width;
  j["truncation_um"] = interval(r.truncation);
  j["half_point_um"] = interval(r.half_point);
  j["largest_remaining_um"] = interval(r.largest_remaining);
  j["grains_before"] = r.before;
  j["grains_after"] = r.after;
  j["area_ratio"] = r.area_ratio;
  j["strays_percent"] = r.strays_fitted ? 100.0 * r.strays : 0.0;
  return j;
}

std::string um(const Estimate& e) { return fmt::format("{:.2f}", e.value); }

}  // namespace

std::string kat_analysis_json(const KatAnalysis& a, const KatAnalysisInput& in) {
  Json j;
  j["particle"] = in.drop.particle.name;
  j["substrate"] = in.drop.substrate.name;
  j["impact_velocity_m_s"] = in.drop.impact_velocity_m_s;
  j["critical_diameter_um"] = interval(a.retention.critical);
  j["adhesive_energy_J_m2"] = Json::object();
  j["methods"] = Json::array();
  for (const MethodResult& m : a.methods) {
    if (m.gamma) {
      j["adhesive_energy_J_m2"][m.info->name] = {
          {"value", m.gamma->value}, {"low", m.gamma->low}, {"high", m.gamma->high}};
    }
    j["methods"].push_back({{"name", m.info->name},
                            {"law", m.info->law},
                            {"assumption", m.info->assumption},
                            {"validity", m.info->validity},
                            {"source", m.info->source},
                            {"needs", m.info->needs},
                            {"measured", m.gamma.has_value()},
                            {"note", m.gamma ? m.gamma->note : ""}});
  }
  j["retained"] = retention_json(a.retention);
  if (!in.drop.contact_radii.empty()) j["contact_radii"] = Json::array();
  for (const ContactRadius& c : in.drop.contact_radii) {
    j["contact_radii"].push_back({{"contact_radius_um", 1e6 * c.contact_radius_m},
                                  {"radius_um", 1e6 * c.radius_m},
                                  {"wavelength_nm", 1e9 * c.wavelength_m},
                                  {"bright_ring_um", 1e6 * bright_ring_m(c)},
                                  {"dark_ring_um", 1e6 * dark_ring_m(c)}});
  }
  j["warnings"] = a.warnings;
  return j.dump(1) + "\n";
}

std::string kat_analysis_text(const KatAnalysis& a, const KatAnalysisInput& in) {
  const RetentionAnalysis& r = a.retention;
  std::string text = fmt::format(
      "{} on {}, impact at {:g} m/s\n"
      "{:.0f} grains before, {:.0f} after; area after over before {:.3g} ({})\n"
      "retained fraction: {}\n\n",
      in.drop.particle.name, in.drop.substrate.name, in.drop.impact_velocity_m_s, r.before, r.after,
      r.area_ratio, in.retention.area_ratio ? "given" : "from the grains that stay", r.decision());
  TextTable diameters({"critical diameter [um]", "value", "95 % low", "high", ""});
  diameters.flush_left(4);
  const auto add = [&](const char* name, const Estimate& e, const char* meaning) {
    diameters.add(
        {name, um(e), fmt::format("{:.2f}", e.low), fmt::format("{:.2f}", e.high), meaning});
  };
  add("d_c", r.critical, r.smeared ? "the 50 % point" : "the truncation");
  add("truncation fit", r.truncation, "interval holds if the truncation is ideal");
  add("50 % point", r.half_point, "with a width");
  add("largest remaining", r.largest_remaining, "the interval is that of d_c");
  text += diameters.text() + "\n";

  TextTable gamma({"Gamma [J/m^2] by", "value", "95 % low", "high", "assumes", ""});
  gamma.flush_left(4);
  gamma.flush_left(5);
  for (const MethodResult& m : a.methods) {
    if (m.gamma) {
      gamma.add({m.info->label, fmt::format("{:.4g}", m.gamma->value),
                 fmt::format("{:.4g}", m.gamma->low), fmt::format("{:.4g}", m.gamma->high),
                 m.info->assumption, m.gamma->note});
    } else {
      gamma.add({m.info->label, "-", "-", "-", m.info->assumption,
                 fmt::format("needs {}", m.info->needs)});
    }
  }
  text += gamma.text();
  if (in.drop.contact_radii.empty()) return text;
  TextTable rings({"a0 [um]", "R [um]", "light [nm]", "bright ring [um]", "dark ring [um]"});
  for (const ContactRadius& c : in.drop.contact_radii) {
    rings.add({fmt::format("{:.2f}", 1e6 * c.contact_radius_m),
               fmt::format("{:.1f}", 1e6 * c.radius_m), fmt::format("{:.0f}", 1e9 * c.wavelength_m),
               fmt::format("{:.2f}", 1e6 * bright_ring_m(c)),
               fmt::format("{:.2f}", 1e6 * dark_ring_m(c))});
  }
  return text + "\nrings of a sphere that does not adhere, beside a0\n" + rings.text();
}

namespace {

std::string classes_csv(const KatAnalysis& a, const KatAnalysisInput& in) {
  const double r = a.retention.area_ratio;
  std::string csv =
      "low_um,high_um,middle_um,count_before,count_after,share_before_percent,share_after_percent,"
      "retained,retained_low,retained_high\n";
  for (const RetentionClass& c : retention_classes(in.before_um, in.after_um)) {
    // Both per area and per ln d, in per cent of all grains before: 10 % classes are the unit.
    const double width = std::log(c.high_um / c.low_um) / std::log1p(kClassWidth);
    csv += fmt::format("{:.5g},{:.5g},{:.5g},{:.0f},{:.0f},{:.6g},{:.6g},{:.6g},{:.6g},{:.6g}\n",
                       c.low_um, c.high_um, c.middle_um(), c.before, c.after,
                       100.0 * c.before / a.retention.before / width,
                       100.0 * c.after / (r * a.retention.before) / width, c.fraction(r),
                       c.fraction_low(r), c.fraction_high(r));
  }
  return csv;
}

std::string curve_csv(const KatAnalysis& a, const KatAnalysisInput& in) {
  constexpr int points = 300;
  const GrainSample sample(in.before_um, in.after_um);
  const double low = sample.classes().front().log_diameter;
  const double high = sample.classes().back().log_diameter;
  const RetentionFit& fit = a.retention.fit();
  const double strays = a.retention.strays;
  std::string csv = "diameter_um,retained\n";
  for (int i = 0; i <= points; ++i) {
    const double x = low + (high - low) * i / points;
    csv += fmt::format("{:.6g},{:.6g}\n", std::exp(x),
                       strays + (1.0 - strays) * retained_fraction(x, fit.log_critical, fit.width));
  }
  return csv;
}

std::string gamma_csv(const KatAnalysis& a) {
  std::string csv = "method,adhesive_energy_J_m2,low_J_m2,high_J_m2\n";
  for (const MethodResult& m : a.methods) {
    if (!m.gamma) continue;
    csv += fmt::format("{},{:.6g},{:.6g},{:.6g}\n", m.info->name, m.gamma->value, m.gamma->low,
                       m.gamma->high);
  }
  return csv;
}

std::string radii_csv(const KatAnalysisInput& in) {
  std::string csv = "contact_radius_um,radius_um,wavelength_nm,bright_ring_um,dark_ring_um\n";
  for (const ContactRadius& c : in.drop.contact_radii) {
    csv += fmt::format("{:.5g},{:.5g},{:.5g},{:.5g},{:.5g}\n", 1e6 * c.contact_radius_m,
                       1e6 * c.radius_m, 1e9 * c.wavelength_m, 1e6 * bright_ring_m(c),
                       1e6 * dark_ring_m(c));
  }
  return csv;
}

}  // namespace

std::map<std::string, std::string> kat_analysis_tables(const KatAnalysis& a,
                                                       const KatAnalysisInput& in) {
  std::map<std::string, std::string> tables = {{"retained.csv", classes_csv(a, in)},
                                               {"retained_curve.csv", curve_csv(a, in)},
                                               {"gamma.csv", gamma_csv(a)}};
  if (!in.drop.contact_radii.empty()) tables["contact_radii.csv"] = radii_csv(in);
  return tables;
}

}  // namespace powderlink::analysis
