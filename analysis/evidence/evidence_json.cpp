// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/evidence/evidence_json.h"

#include <cmath>
#include <nlohmann/json.hpp>

namespace powderlink::analysis {

using Json = nlohmann::ordered_json;

namespace {

const char* role_name(ParameterEstimate::Role role) {
  switch (role) {
    case ParameterEstimate::Role::fitted:
      return "fitted";
    case ParameterEstimate::Role::held:
      return "held";
    case ParameterEstimate::Role::fixed:
      break;
  }
  return "fixed";
}

Json json_of(const Candidate& c, double baseline_bic) {
  Json j;
  j["effect"] = c.name;
  j["parameters"] = json_of_parameters(c);
  j["rms_relative_error"] = json_number(c.rms_relative_error);
  j["chi2_per_dof"] = json_number(c.chi2_per_dof());
  j["delta_bic"] = json_number(c.bic - baseline_bic);
  j["loo_rms_relative_error"] = json_number(c.loo_rms_relative_error);
  j["plausible"] = c.plausible;
  j["why"] = c.why;
  Json roles = Json::object();
  for (const ParameterEstimate& p : c.parameters) roles[p.name] = role_name(p.role);
  j["roles"] = roles;
  j["least_p_value"] = least_p_value(c.tests);
  return j;
}

}  // namespace

Json json_number(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }

Json json_of_parameters(const Candidate& c) {
  Json j = Json::object();
  for (const ParameterEstimate& p : c.parameters) j[p.name] = json_number(p.value);
  return j;
}

Json json_of(const std::vector<TrendTest>& tests) {
  Json list = Json::array();
  for (const TrendTest& t : tests) {
    list.push_back({{"variable", t.variable},
                    {"test", t.test},
                    {"p_value", t.p_value},
                    {"p_corrected", t.p_corrected},
                    {"counts", t.counts}});
  }
  return list;
}

Json json_of(const Diagnosis& d, const Observations& observations) {
  const Candidate& none = d.baseline();
  Json j;
  j["verdict"] = to_string(d.verdict);
  j["best"] = d.best.empty() ? Json(nullptr) : Json(d.best);
  j["baseline"] = {{"rms_relative_error", json_number(none.rms_relative_error)},
                   {"chi2_per_dof", json_number(none.chi2_per_dof())},
                   {"parameters", json_of_parameters(none)},
                   {"trends", json_of(none.tests)}};
  j["ranking"] = Json::array();
  for (const Candidate& c : d.ranking) j["ranking"].push_back(json_of(c, none.bic));
  j["indistinguishable"] = d.indistinguishable;
  j["next_measurement"] = d.next.text;
  j["next_velocity_m_s"] = json_number(d.next.velocity_m_s);
  j["pairs"] = Json::array();
  for (const Candidate& c : d.pairs) j["pairs"].push_back(json_of(c, none.bic));
  j["patterns"] = Json::array();
  for (const Pattern& p : d.patterns) {
    j["patterns"].push_back({{"name", p.name},
                             {"text", p.text},
                             {"chi2", json_number(p.chi2)},
                             {"parameters", p.parameters}});
  }
  j["noise"] = observations.noise.text();
  j["words"] = d.words;
  return j;
}

Json json_of(const Comparison& c, const Observations& observations, const std::string& backend) {
  Json j;
  j["parameters"] = json_of_parameters(c.fit);
  j["rms_relative_error"] = json_number(c.rms_relative_error);
  j["chi2_per_dof"] = json_number(c.chi2_per_dof);
  j["points"] = Json::array();
  for (std::size_t i = 0; i < c.model.size(); ++i) {
    const Observation& o = observations.list[i];
    j["points"].push_back({{"impact_velocity_m_s", o.row.impact_velocity_m_s},
                           {"measured", o.measured},
                           {"model", json_number(c.model[i])},
                           {"sigma_relative", o.sigma},
                           {"residual_sigma", json_number(c.residuals[i])}});
  }
  j["trends"] = json_of(c.tests);
  j["verdict"] = to_string(c.verdict);
  j["backend"] = backend;
  j["intervals"] = Json::object();
  for (std::size_t i = 0; i < c.intervals.size(); ++i) {
    const ProfileInterval& p = c.intervals[i];
    j["intervals"][c.fit.problem.parameters[i].name] = {{"low", json_number(p.low)},
                                                        {"high", json_number(p.high)},
                                                        {"open_low", p.open_low},
                                                        {"open_high", p.open_high}};
  }
  j["correlation"] = Json::array();
  const auto& correlation = c.uncertainty.correlation;
  for (long row = 0; row < correlation.rows(); ++row) {
    Json values = Json::array();
    for (long column = 0; column < correlation.cols(); ++column)
      values.push_back(json_number(correlation(row, column)));
    j["correlation"].push_back(values);
  }
  j["flat_directions"] = c.uncertainty.flat;
  j["plausible"] = c.fit.plausible;
  j["why"] = c.fit.why;
  j["noise"] = observations.noise.text();
  j["words"] = c.words;
  return j;
}

}  // namespace powderlink::analysis
