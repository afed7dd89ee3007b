// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/report/report_page.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <kainjow/mustache.hpp>

#include "analysis/evidence/quantity.h"
#include "analysis/evidence/residual_checks.h"
#include "analysis/evidence/verdict_words.h"
#include "analysis/report/column_title.h"
#include "analysis/report/inline_svg.h"
#include "analysis/report/report_words.h"
#include "analysis/report/typeset.h"
#include "base/files/file_text.h"
#include "base/invalid_input.h"
#include "base/text/units.h"

namespace powderlink::analysis {

namespace mustache = kainjow::mustache;
using Data = mustache::data;

namespace {

constexpr const char* kNone = "–";

std::string percent(double fraction) {
  return std::isfinite(fraction) ? fmt::format("{:.1f} %", 100.0 * fraction) : kNone;
}
std::string number(double value, int digits) {
  return std::isfinite(value) ? fmt::format("{:.{}g}", value, digits) : kNone;
}

Data list_of(const std::vector<std::string>& texts) {
  Data list(Data::type::list);
  for (const std::string& text : texts) list << Data(sentence(text));
  return list;
}

Data figure(const Figure& f, const char* css_class, const std::filesystem::path& folder) {
  Data d;
  d.set("name", f.name);
  d.set("class", css_class);
  d.set("caption", f.caption);
  d.set("svg", inline_svg(file_text(folder / (f.name + ".svg")), f.name));
  return d;
}

std::string interval_text(const ProfileInterval& i) {
  return fmt::format("{}{:.4g} to {:.4g}{}", i.open_low ? "≤ " : "", i.low, i.high,
                     i.open_high ? " or more" : "");
}

Data parameter_table(const std::string& caption, const Candidate& c,
                     const std::vector<ProfileInterval>& intervals) {
  Data rows(Data::type::list);
  std::size_t fitted = 0;
  for (const ParameterEstimate& p : c.parameters) {
    const bool is_fitted = p.role == ParameterEstimate::Role::fitted;
    Data d;
    d.set("name", p.name);
    d.set("of", p.effect.empty() ? "interface" : p.effect);
    d.set("value", fmt::format("{:.4g}", p.value));
    d.set("unit", typeset(unit_of(p.name)));
    d.set("interval", is_fitted                                 ? interval_text(intervals[fitted])
                      : p.role == ParameterEstimate::Role::held ? "held: not determined"
                                                                : "given");
    d.set("bounds", is_fitted ? fmt::format("{:.4g} to {:.4g}{}", p.lower, p.upper,
                                            p.at_bound ? " (reached)" : "")
                              : kNone);
    d.set("range", fmt::format("{:.4g} to {:.4g}", p.plausible_lower, p.plausible_upper));
    d.set("plausible", p.plausible() ? "yes" : "no");
    d.set("class", p.plausible() ? "good" : "bad");
    d.set("source", typeset(p.source));
    rows << d;
    if (is_fitted) ++fitted;
  }
  Data table;
  table.set("caption", caption);
  table.set("parameters", rows);
  return table;
}

Data parameter_tables(const StudyResult& r) {
  Data tables(Data::type::list);
  tables << parameter_table("The model of this study", r.comparison.fit, r.comparison.intervals);
  for (const Candidate* c : r.leading()) {
    tables << parameter_table(fmt::format("With {} added (rms {})", c->name, rms_text(c->rms)), *c,
                              intervals_of(*c, r.observations));
  }
  return tables;
}

Data rows(const StudyResult& r) {
  Data list(Data::type::list);
  for (std::size_t i = 0; i < r.observations.list.size(); ++i) {
    const Observation& o = r.observations.list[i];
    const bool relative = o.row.kind() == KatRow::Kind::critical_diameter;
    const auto difference = [&](double model) {
      return relative ? fmt::format("{:+.1f} %", 100.0 * o.error(model))
                      : fmt::format("{:+.2g}", o.error(model));
    };
    Data d;
    d.set("v", fmt::format("{:g}", o.row.impact_velocity_m_s));
    d.set("size", o.row.diameter_um ? fmt::format("{:g}", *o.row.diameter_um) : kNone);
    const Quantity& quantity = quantity_of(o.row.kind());
    const std::string unit = typeset(quantity.unit);
    d.set("quantity",
          unit.empty() ? quantity.name : fmt::format("{} ({})", quantity.name, unit.substr(1)));
    d.set("measured", fmt::format("{:.4g}", o.measured));
    d.set("sigma", relative ? percent(o.sigma) : fmt::format("{:.2g}", o.sigma));
    d.set("model", fmt::format("{:.4g}", r.comparison.model[i]));
    d.set("difference", difference(r.comparison.model[i]));
    d.set("residual", fmt::format("{:+.1f}", r.comparison.residuals[i]));
    d.set("far", std::fabs(r.comparison.residuals[i]) > kOutside_sigma);
    if (r.dem) {
      d.set("dem", fmt::format("{:.4g}", r.dem->model_um[i]));
      d.set("dem_difference", difference(r.dem->model_um[i]));
      d.set("dem_residual", fmt::format("{:+.1f}", r.dem->residuals[i]));
      d.set("dem_far", std::fabs(r.dem->residuals[i]) > kOutside_sigma);
    }
    list << d;
  }
  return list;
}

Data tests(const StudyResult& r) {
  Data list(Data::type::list);
  for (const TrendTest& t : r.comparison.tests) {
    Data d;
    d.set("variable", column_words(t.variable));
    d.set("test", t.test);
    d.set("p", number(t.p_value, 2));
    d.set("p_corrected", number(t.p_corrected, 2));
    d.set("small", t.counts && t.p_corrected < kAlarm);
    d.set("counts", t.counts ? "yes" : "no");
    list << d;
  }
  return list;
}

Data candidates(const Diagnosis& d) {
  Data list(Data::type::list);
  for (const Candidate* c : ranked(d)) {
    Data row;
    row.set("name", c->name);
    row.set("delta_bic", fmt::format("{:+.1f}", c->bic - d.baseline().bic));
    row.set("rms", rms_text(c->rms));
    row.set("loo", rms_text(c->left_out));
    row.set("chi2", number(c->chi2_per_dof(), 3));
    row.set("plausible", !c->acts ? kNone : c->plausible ? "yes" : typeset("no: " + c->why));
    row.set("class", !c->acts ? "soft" : c->plausible ? "good" : "bad");
    row.set("parameters", typeset(c->acts ? parameter_text(*c) : c->why));
    list << row;
  }
  return list;
}

Data study(const ReportPage& page, std::size_t i) {
  constexpr std::size_t short_table = 16;
  const StudyResult& r = *page.results[i];
  const StudyFigures& f = page.figures[i];
  Data d;
  d.set("id", fmt::format("study-{}", i + 1));
  d.set("name", r.study.name);
  d.set("particle", column_words(r.study.particle.name));
  d.set("substrate", column_words(r.study.substrate.name));
  d.set("row_count", std::to_string(r.observations.list.size()));
  d.set("effects", r.effects().empty() ? "none" : r.effects());
  d.set("noise", typeset(r.observations.noise_text));
  d.set("verdict", to_string(r.comparison.verdict));
  d.set("class", to_string(r.comparison.verdict));
  d.set("rms", rms_text(r.comparison.rms));
  d.set("rms_dem", r.dem ? percent(r.dem->rms_relative_error) : kNone);
  const StudyResult& first = *page.results.front();
  const double first_error = axis_error(first.comparison.rms).hundredths;
  const double error =
      r.dem ? 100.0 * r.dem->rms_relative_error : axis_error(r.comparison.rms).hundredths;
  d.set("of_first", i > 0 && same_measurements(page.results)
                        ? fmt::format("{:.2g}", error / first_error)
                        : kNone);
  d.set("chi2", number(r.comparison.chi2_per_dof, 3));
  d.set("headline", headline(r));
  d.set("fit_words", list_of(fit_words(r)));
  d.set("trend_words", list_of(trend_words(r)));
  d.set("compare_words", list_of(r.comparison.words));
  Data fits(Data::type::list);
  for (const Figure& each : f.fit) fits << figure(each, "main", page.folder);
  d.set("fit", fits);
  Data residuals(Data::type::list);
  for (const Figure& each : f.residuals) residuals << figure(each, "small", page.folder);
  d.set("residuals", residuals);
  d.set("short", r.observations.list.size() <= short_table);
  d.set("other_kinds", std::any_of(r.observations.list.begin(), r.observations.list.end(),
                                   [](const Observation& o) {
                                     return o.row.kind() != KatRow::Kind::critical_diameter;
                                   }));
  d.set("has_dem", r.dem.has_value());
  d.set("rows", rows(r));
  d.set("tests", tests(r));
  d.set("parameter_tables", parameter_tables(r));
  const std::vector<std::string> open = open_questions(r);
  d.set("any_open", !open.empty());
  d.set("open", list_of(open));
  d.set("diagnosed", r.diagnosis.has_value());
  if (r.diagnosis) {
    d.set("words", list_of(r.diagnosis->words));
    d.set("candidates", candidates(*r.diagnosis));
    d.set("next_words", list_of(parts(r.diagnosis->next.text)));
    d.set("ranking", figure(*f.ranking, "full", page.folder));
    d.set("next", figure(*f.next, "main", page.folder));
  }
  return d;
}

}  // namespace

std::string html(const ReportPage& page) {
  Data d;
  const std::string& name = page.results.front()->study.name;
  const bool many = page.results.size() > 1;
  d.set("title", many ? fmt::format("{} and {} more", name, page.results.size() - 1) : name);
  d.set("version", page.version);
  d.set("date", date_text());
  d.set("many", many);
  d.set("staircase_title", !many                             ? "Overview"
                           : same_measurements(page.results) ? "Error before and after each effect"
                                                             : "Overview of the studies");
  if (page.staircase) d.set("staircase", figure(*page.staircase, "main", page.folder));
  Data studies(Data::type::list);
  for (std::size_t i = 0; i < page.results.size(); ++i) studies << study(page, i);
  d.set("studies", studies);
  Data facts(Data::type::list);
  for (const auto& [what, value] : page.facts) {
    Data fact;
    fact.set("name", what);
    fact.set("value", value);
    facts << fact;
  }
  d.set("facts", facts);
  d.set("figure_folder", page.folder.filename().string());
  d.set("figure_html", mustache::partial([] { return std::string(kFigureTemplate); }));
  d.set("parameters_html", mustache::partial([] { return std::string(kParametersTemplate); }));

  mustache::mustache engine{std::string(kReportTemplate)};
  std::string text = engine.render(d);
  if (!engine.is_valid()) {
    throw InvalidInput("the report's template", engine.error_message(), "a Mustache template",
                       "mend analysis/report/*.html.in and build again");
  }
  return text;
}

}  // namespace powderlink::analysis
