// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/evidence/evidence_json.h"

#include <cmath>
#include <nlohmann/json.hpp>

#include "analysis/evidence/quantity.h"

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

/// "rms_relative_error" always (null without diameters), and one key for each other quantity.
void put_errors(Json& j, const std::string& prefix, const std::vector<QuantityError>& errors) {
  j[prefix + "relative_error"] = json_number(rms_relative_error(errors));
  for (const QuantityError& e : errors) {
    if (e.kind == KatRow::Kind::retained_share) j[prefix + "share_error"] = json_number(e.rms);
    if (e.kind == KatRow::Kind::residual_speed) j[prefix + "speed_error_m_s"] = json_number(e.rms);
  }
}

const char* origin_name(NoiseOrigin origin) {
  switch (origin) {
    case NoiseOrigin::stated:
      return "stated";
    case NoiseOrigin::counted:
      return "counted";
    case NoiseOrigin::replicates:
      return "replicates";
    case NoiseOrigin::assumed:
      break;
  }
  return "assumed";
}

Json point_of(const Observation& o, double model, double residual) {
  const bool relative = o.row.kind() == KatRow::Kind::critical_diameter;
  const char* sigma = relative                                       ? "sigma_relative"
                      : o.row.kind() == KatRow::Kind::retained_share ? "sigma_share"
                                                                     : "sigma_m_s";
  Json j = {{"impact_velocity_m_s", o.row.impact_velocity_m_s},
            {"quantity", quantity_of(o.row.kind()).name}};
  if (o.row.diameter_um) j["diameter_um"] = *o.row.diameter_um;
  j["measured"] = o.measured;
  j["model"] = json_number(model);
  j[sigma] = o.sigma;
  j["noise"] = origin_name(o.origin);
  j["residual_sigma"] = json_number(residual);
  return j;
}

Json json_of(const Candidate& c, double baseline_bic) {
  Json j;
  j["effect"] = c.name;
  j["parameters"] = json_of_parameters(c);
  put_errors(j, "rms_", c.rms);
  j["chi2_per_dof"] = json_number(c.chi2_per_dof());
  j["delta_bic"] = json_number(c.bic - baseline_bic);
  put_errors(j, "loo_rms_", c.left_out);
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
  put_errors(j["baseline"], "rms_", none.rms);
  j["baseline"]["chi2_per_dof"] = json_number(none.chi2_per_dof());
  j["baseline"]["parameters"] = json_of_parameters(none);
  j["baseline"]["trends"] = json_of(none.tests);
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
  j["noise"] = observations.noise_text;
  j["words"] = d.words;
  return j;
}

Json json_of(const Comparison& c, const Observations& observations, const std::string& backend) {
  Json j;
  j["parameters"] = json_of_parameters(c.fit);
  put_errors(j, "rms_", c.rms);
  j["chi2_per_dof"] = json_number(c.chi2_per_dof);
  j["points"] = Json::array();
  for (std::size_t i = 0; i < c.model.size(); ++i)
    j["points"].push_back(point_of(observations.list[i], c.model[i], c.residuals[i]));
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
  j["noise"] = observations.noise_text;
  j["words"] = c.words;
  return j;
}

}  // namespace powderlink::analysis
