// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "analysis/sizes/pictures/psd_report.h"

namespace powderlink::analysis {

namespace {

using Json = nlohmann::ordered_json;

Json pair(const ConfidenceInterval& i) { return Json::array({i.low, i.high}); }

Json law(const std::optional<RosinRammlerFit>& fit) {
  if (!fit || !fit->fits()) return nullptr;
  Json j;
  j["x0_um"] = fit->law.x0_um;
  j["n"] = fit->law.n;
  j["r_squared"] = fit->r_squared;
  j["x0_sigma_um"] = fit->x0_sigma_um;
  j["n_sigma"] = fit->n_sigma;
  j["miss"] = fit->miss;
  j["chance"] = fit->chance;
  if (std::isfinite(fit->law.max_um)) {
    j["min_um"] = fit->law.min_um;
    j["max_um"] = fit->law.max_um;
    j["origin_um"] = fit->law.origin_um;
  }
  return j;
}

std::string optional_cell(const std::optional<double>& value) {
  return value ? fmt::format("{:.6g}", *value) : "";
}

/// A name as a cell, by RFC 4180.
std::string in_cell(std::string text) {
  for (std::size_t at = 0; (at = text.find('"', at)) != std::string::npos; at += 2)
    text.insert(at, "\"");
  return "\"" + text + "\"";
}

std::string particles_table(const PsdReport& r) {
  std::string text;
  if (r.set.pixel_size_um) text += fmt::format("# pixel_size_um: {:.9g}\n", *r.set.pixel_size_um);
  text +=
      "file,place,area_um2,perimeter_um,area_diameter_um,perimeter_diameter_um,circularity,"
      "aspect_ratio,feret_um,speck\n";
  for (std::size_t i = 0; i < r.set.particles.size(); ++i) {
    const Particle& p = r.set.particles[i];
    text +=
        fmt::format("{},{},{:.9g},{:.9g},{:.6g},{:.6g},{:.5g},{},{},{}\n",
                    in_cell(r.set.files[p.file]), p.place, p.area_um2, p.perimeter_um,
                    p.area_diameter_um(), p.perimeter_diameter_um(), p.circularity(),
                    optional_cell(p.aspect_ratio), optional_cell(p.feret_um), r.speck[i] ? 1 : 0);
  }
  return text;
}

std::string distribution_table(const PsdReport& r) {
  constexpr std::size_t most = 500;  // points of a figure
  const std::vector<double>& d = r.number->diameters_um();
  const std::vector<double> number = r.number->finer(), mass = r.mass->finer();
  const auto at = [](const std::optional<RosinRammlerFit>& fit, double x) {
    return fit && fit->fits() ? fmt::format("{:.6g}", fit->law.finer(x)) : std::string();
  };
  std::string text =
      "diameter_um,finer_number,finer_mass,rr_number,rr_mass,rr_cut_number,rr_cut_mass\n";
  const std::size_t points = std::min(most, d.size());
  for (std::size_t k = 0; k < points; ++k) {
    const std::size_t i = points == 1 ? 0 : k * (d.size() - 1) / (points - 1);
    text += fmt::format("{:.6g},{:.6g},{:.6g},{},{},{},{}\n", d[i], number[i], mass[i],
                        at(r.rr_number, d[i]), at(r.rr_mass, d[i]), at(r.cut_number, d[i]),
                        at(r.cut_mass, d[i]));
  }
  return text;
}

/// Equal classes; their number by Rice's rule.
std::string histogram_table(const PsdReport& r) {
  const std::vector<double>& d = r.number->diameters_um();
  const auto classes = static_cast<int>(
      std::clamp(std::ceil(2.0 * std::cbrt(static_cast<double>(d.size()))), 5.0, 40.0));
  const double low = d.front(), width = std::max((d.back() - low) / classes, 1e-9);
  std::vector<double> number(static_cast<std::size_t>(classes), 0.0), mass = number;
  const auto n = static_cast<double>(d.size());
  for (std::size_t i = 0; i < d.size(); ++i) {
    const auto k = static_cast<std::size_t>(std::min<double>(classes - 1, (d[i] - low) / width));
    number[k] += 1.0 / n;
    mass[k] += r.mass->weights()[i] / n;
  }
  std::string text = "low_um,high_um,share_number,share_mass\n";
  for (std::size_t k = 0; k < number.size(); ++k) {
    text += fmt::format("{:.6g},{:.6g},{:.6g},{:.6g}\n", low + static_cast<double>(k) * width,
                        low + static_cast<double>(k + 1) * width, number[k], mass[k]);
  }
  return text;
}

}  // namespace

std::string psd_json(const PsdReport& r) {
  Json j;
  j["count"] = r.set.particles.size();
  const char* const names[] = {"d10", "d50", "d90"};
  for (std::size_t k = 0; k < 3; ++k) j[fmt::format("{}_um", names[k])] = r.by_number[k].value;
  for (std::size_t k = 0; k < 3; ++k) j[fmt::format("{}_mass_um", names[k])] = r.by_mass[k].value;
  j["rosin_rammler"] = law(r.rr_number);
  j["rosin_rammler_mass"] = law(r.rr_mass);
  j["rosin_rammler_cut"] = law(r.cut_number);
  j["rosin_rammler_cut_mass"] = law(r.cut_mass);
  Json& intervals = j["intervals"];
  for (std::size_t k = 0; k < 3; ++k) {
    intervals[fmt::format("{}_um", names[k])] = pair(r.by_number[k].interval);
    intervals[fmt::format("{}_mass_um", names[k])] = pair(r.by_mass[k].interval);
  }
  intervals["level"] = r.options.bootstrap.level;
  const bool area = r.options.diameter == DiameterKind::area;
  j["diameter"] = area ? "sqrt(4A/pi)" : "4A/P";
  j[area ? "d50_4A_P_um" : "d50_sqrt_4A_pi_um"] = r.d50_other.value;
  j["circularity"] = {{"p10", r.circularity[0].value},
                      {"p50", r.circularity[1].value},
                      {"p90", r.circularity[2].value}};
  if (r.with_aspect_ratio > 0) {
    j["aspect_ratio"] = {{"p10", r.aspect_ratio[0].value},
                         {"p50", r.aspect_ratio[1].value},
                         {"p90", r.aspect_ratio[2].value}};
  } else {
    j["aspect_ratio"] = nullptr;
  }
  j["specks"] = r.specks;
  j["pixel_size_um"] = r.set.pixel_size_um ? Json(*r.set.pixel_size_um) : Json(nullptr);
  j["files"] = r.set.files;
  j["notes"] = r.set.notes;
  return j.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

std::vector<std::pair<std::string, std::string>> psd_tables(const PsdReport& report) {
  return {{"particles.csv", particles_table(report)},
          {"distribution.csv", distribution_table(report)},
          {"histogram.csv", histogram_table(report)}};
}

}  // namespace powderlink::analysis
