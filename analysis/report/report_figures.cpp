// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/report/report_figures.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <functional>
#include <set>
#include <utility>

#include "analysis/evidence/quantity.h"
#include "analysis/evidence/verdict_words.h"
#include "analysis/report/column_title.h"
#include "analysis/report/report_words.h"
#include "analysis/report/typeset.h"
#include "analysis/report/value_range.h"
#include "base/files/write_file.h"
#include "base/gnuplot/gnuplot.h"

namespace powderlink::analysis {

namespace fs = std::filesystem;

namespace {

/// A cell that gnuplot shows on hover.
std::string hover_cell(std::string text) {
  std::replace_if(
      text.begin(), text.end(),
      [](char c) {
        return c == '"' || c == '\'' || c == '\\' || static_cast<unsigned char>(c) < ' ';
      },
      ' ');
  std::replace(text.begin(), text.end(), ',', ';');  // ends a label even within quotes
  return '"' + text + '"';
}

std::string number(double value) {
  return std::isfinite(value) ? fmt::format("{:.8g}", value) : "";
}

std::string definitions(const ValueRange& range, const char* axis) {
  return fmt::format("{0}_low={1:.9g}; {0}_high={2:.9g}", axis, range.low, range.high);
}

class Sheet {
 public:
  Sheet(fs::path folder, std::string name) : folder_(std::move(folder)), name_(std::move(name)) {}
  /// Writes NAME[part].csv and returns "variable='its path'".
  std::string table(const char* variable, const std::string& part, const std::string& text) const {
    const fs::path file = folder_ / (name_ + part + ".csv");
    write_file(file, text);
    return fmt::format("{}={}", variable, gnuplot_string(fs::absolute(file).string()));
  }
  Figure draw(const std::string& script, const std::vector<std::string>& definitions,
              const std::string& caption) const {
    draw_figure(folder_ / (name_ + ".svg"), script, fmt::format("{}", fmt::join(definitions, "; ")),
                "use 'compare' and 'diagnose'");
    return {name_, caption};
  }

 private:
  fs::path folder_;
  std::string name_;
};

double dem_um(const StudyResult& r, std::size_t i) { return r.dem ? r.dem->model_um[i] : NAN; }
double dem_residual(const StudyResult& r, std::size_t i) {
  return r.dem ? r.dem->residuals[i] : NAN;
}

std::string row_hover(const StudyResult& r, std::size_t i) {
  const Observation& o = r.observations.list[i];
  const std::string unit = typeset(quantity_of(o.row.kind()).unit);
  return fmt::format("{:g} m/s{}: measured {:.4g} ± {:.2g}{}, model {:.4g}{}, {:+.1f} sigma",
                     o.row.impact_velocity_m_s,
                     o.row.diameter_um ? fmt::format(", {:g} µm", *o.row.diameter_um) : "",
                     o.measured, r.measured_sigma(i), unit, r.comparison.model[i], unit,
                     r.comparison.residuals[i]);
}

std::string dem_hover(const StudyResult& r, std::size_t i) {
  if (!r.dem) return "";
  return fmt::format("{:g} m/s: LIGGGHTS {:.4g} µm, {:+.1f} sigma",
                     r.observations.list[i].row.impact_velocity_m_s, dem_um(r, i),
                     dem_residual(r, i));
}

/// Over velocity for critical diameters, else over the grains' diameter.
double abscissa(const Observation& o) {
  return o.row.kind() == KatRow::Kind::critical_diameter ? o.row.impact_velocity_m_s
                                                         : o.row.diameter_um.value_or(NAN);
}

double velocity_of(const StudyResult& r, std::size_t i) {
  return r.observations.list[i].row.impact_velocity_m_s;
}

/// Those of one kind by velocity, then by abscissa.
std::vector<std::size_t> rows_of(const StudyResult& r, KatRow::Kind kind) {
  std::vector<std::size_t> rows;
  for (std::size_t i = 0; i < r.observations.list.size(); ++i) {
    if (r.observations.list[i].row.kind() == kind) rows.push_back(i);
  }
  std::stable_sort(rows.begin(), rows.end(), [&](std::size_t a, std::size_t b) {
    return std::pair(velocity_of(r, a), abscissa(r.observations.list[a])) <
           std::pair(velocity_of(r, b), abscissa(r.observations.list[b]));
  });
  return rows;
}

/// How many velocities these rows have.
std::size_t velocities_of(const StudyResult& r, KatRow::Kind kind) {
  std::set<double> different;
  for (const std::size_t i : rows_of(r, kind)) different.insert(velocity_of(r, i));
  return different.size();
}

/// The rows of one kind; `x` and `y` grow to hold them.
std::string rows_table(const StudyResult& r, KatRow::Kind kind, ValueRange& x, ValueRange& y) {
  std::string text =
      "impact_velocity_m_s,x,measured,sigma,model,residual_sigma,dem,dem_residual_sigma,hover,"
      "dem_hover,velocity_label\n";
  const std::vector<std::size_t> order = rows_of(r, kind);
  for (std::size_t n = 0; n < order.size(); ++n) {
    const std::size_t i = order[n];
    const Observation& o = r.observations.list[i];
    const bool last = n + 1 == order.size() || velocity_of(r, order[n + 1]) != velocity_of(r, i);
    x.add(abscissa(o));
    for (const double value : {o.measured - r.measured_sigma(i), o.measured + r.measured_sigma(i),
                               r.comparison.model[i], dem_um(r, i)})
      y.add(value);
    text += fmt::format("{},{},{},{},{},{},{},{},{},{},{}\n", number(o.row.impact_velocity_m_s),
                        number(abscissa(o)), number(o.measured), number(r.measured_sigma(i)),
                        number(r.comparison.model[i]), number(r.comparison.residuals[i]),
                        number(dem_um(r, i)), number(dem_residual(r, i)),
                        hover_cell(row_hover(r, i)), hover_cell(dem_hover(r, i)),
                        hover_cell(last ? fmt::format("{:g} m/s", velocity_of(r, i)) : ""));
    // Ends the line through the rows of one velocity.
    if (last && kind != KatRow::Kind::critical_diameter) text += "\n";
  }
  return text;
}

bool has(const StudyResult& r, KatRow::Kind kind) {
  return std::any_of(r.observations.list.begin(), r.observations.list.end(),
                     [&](const Observation& o) { return o.row.kind() == kind; });
}

Figure draw_fit(const StudyResult& r, const Quantity& quantity, const Sheet& sheet) {
  ValueRange x, y;
  const std::string rows = rows_table(r, quantity.kind, x, y);
  std::string curve = "velocity_m_s,diameter_um,low_um,high_um\n";
  for (std::size_t i = 0; i < r.curve.velocity_m_s.size(); ++i) {
    curve += fmt::format("{},{},{},{}\n", number(r.curve.velocity_m_s[i]),
                         number(r.curve.diameter_um[i]), number(r.curve.low_um[i]),
                         number(r.curve.high_um[i]));
  }
  const bool diameters = quantity.kind == KatRow::Kind::critical_diameter;
  const bool one_curve = diameters && !r.curve.velocity_m_s.empty();
  return sheet.draw(
      "report_fit.gp",
      {sheet.table("table", "", rows), sheet.table("curve", "_curve", curve),
       "y_title=" + gnuplot_string(quantity.title),
       fmt::format("one_curve={}; diameters={}; n_dem={}; velocities={}", one_curve ? 1 : 0,
                   diameters ? 1 : 0, r.dem ? r.dem->model_um.size() : 0,
                   velocities_of(r, quantity.kind)),
       definitions(x, "x"), definitions(y, "y")},
      fmt::format("{}: measured {} with standard deviation, and the model {}{}.", r.study.name,
                  quantity.name,
                  r.effects().empty() ? "without an added effect" : "with " + r.effects(),
                  one_curve ? "; band: one standard deviation of the fit" : ""));
}

struct Column {
  std::string name, title;
  std::function<double(const Observation&)> value;
};

std::vector<Column> columns(const StudyResult& r) {
  std::vector<Column> list = {
      {"impact_velocity_m_s", column_title("impact_velocity_m_s"),
       [](const Observation& o) { return o.row.impact_velocity_m_s; }},
      {"critical_diameter_um", "measured critical diameter (µm)",
       [](const Observation& o) { return o.row.critical_diameter_um.value_or(NAN); }},
      {"diameter_um", "diameter of the grains (µm)",
       [](const Observation& o) { return o.row.diameter_um.value_or(NAN); }},
      {"contact_time_us", "measured contact time (µs)",
       [](const Observation& o) { return o.row.contact_time_us.value_or(NAN); }}};
  for (const auto& [name, first] : r.observations.list.front().row.other) {
    list.push_back({name, column_title(name), [key = name](const Observation& o) {
                      const auto found = o.row.other.find(key);
                      return found != o.row.other.end() ? found->second : NAN;
                    }});
  }
  const auto flat = [&](const Column& c) {
    ValueRange range;
    for (const Observation& o : r.observations.list) range.add(c.value(o));
    return !(range.high > range.low);
  };
  list.erase(std::remove_if(list.begin(), list.end(), flat), list.end());
  return list;
}

Figure draw_residuals(const StudyResult& r, const Column& column, const Sheet& sheet) {
  ValueRange x, y;
  std::string text = "x,residual_sigma,dem_residual_sigma,hover,dem_hover\n";
  for (std::size_t i = 0; i < r.observations.list.size(); ++i) {
    const double value = column.value(r.observations.list[i]);
    x.add(value);
    y.add(std::fabs(r.comparison.residuals[i]));
    y.add(std::fabs(dem_residual(r, i)));
    text += fmt::format("{},{},{},{},{}\n", number(value), number(r.comparison.residuals[i]),
                        number(dem_residual(r, i)), hover_cell(row_hover(r, i)),
                        hover_cell(dem_hover(r, i)));
  }
  return sheet.draw(
      "report_residuals.gp",
      {sheet.table("table", "", text), "x_title=" + gnuplot_string(column.title),
       fmt::format("n_dem={}", r.dem ? r.dem->model_um.size() : 0), definitions(x, "x"),
       fmt::format("y_high={:.9g}", y.high)},
      fmt::format("Residuals over {}; grey: within {:g} sigmas.", column.title, kOutside_sigma));
}

Figure draw_ranking(const StudyResult& r, const Sheet& sheet) {
  const Diagnosis& d = *r.diagnosis;
  ValueRange evidence, loo;
  evidence.add(0.0);
  std::vector<std::string> names;
  std::string text = "row,effect,evidence,loo_percent,plausible,hover\n";
  for (const Candidate* c : ranked(d)) {
    const double gain = d.baseline().bic - c->bic;
    const double left_out = axis_error(c->left_out).hundredths;
    evidence.add(gain);
    loo.add(left_out);
    names.push_back(c->name);
    text +=
        fmt::format("{},{},{},{},{},{}\n", names.size(), c->name, number(gain), number(left_out),
                    c->added.empty() || !c->acts ? -1
                    : c->plausible               ? 1
                                                 : 0,
                    hover_cell(fmt::format("{}: delta BIC {:+.1f}, rms {}, left out {}; {}; {}",
                                           c->name, -gain, rms_text(c->rms), rms_text(c->left_out),
                                           c->acts ? parameter_text(*c) : c->why,
                                           c->plausible ? "plausible" : "not plausible")));
  }
  return sheet.draw(
      "report_ranking.gp",
      {sheet.table("table", "", text), fmt::format("rows={}", names.size()),
       "names=" + gnuplot_string(fmt::format("{}", fmt::join(names, " "))),
       fmt::format("lowest={:.9g}; widest={:.9g}; most_loo={:.9g}; unit={}", evidence.low,
                   evidence.high, loo.high,
                   gnuplot_string(axis_error(d.baseline().left_out).unit))},
      fmt::format("Ranking of the explanations of {}: how much BIC falls when an effect is added, "
                  "and the error on rows that were left out of the fit. "
                  "Full: possible values; pale: values that are not possible; "
                  "grey: the study's own model and effects that these rows cannot show.",
                  r.study.name));
}

Figure draw_next(const StudyResult& r, const Sheet& sheet) {
  const NextMeasurement& next = r.diagnosis->next;
  ValueRange x, y;
  const std::string rows = rows_table(r, KatRow::Kind::critical_diameter, x, y);
  std::vector<std::string> names;
  std::string header = "velocity_m_s";
  for (const PredictedCurve& c : next.curves) {
    names.push_back(c.name);
    header += fmt::format(",diameter_{0},low_{0},high_{0}", names.size());
    for (std::size_t i = 0; i < c.velocity_m_s.size(); ++i) {
      x.add(c.velocity_m_s[i]);
      y.add(c.diameter_um[i]);
    }
  }
  std::string text = header + "\n";
  std::string proposed = "velocity_m_s,diameter_um,hover\n";
  const std::vector<double>& velocities = next.curves.front().velocity_m_s;
  for (std::size_t i = 0; i < velocities.size(); ++i) {
    text += number(velocities[i]);
    for (const PredictedCurve& c : next.curves) {
      text += fmt::format(",{},{},{}", number(c.diameter_um[i]), number(c.low_um[i]),
                          number(c.high_um[i]));
      if (velocities[i] == next.velocity_m_s) {
        proposed +=
            fmt::format("{},{},{}\n", number(velocities[i]), number(c.diameter_um[i]),
                        hover_cell(fmt::format(
                            "{:.3g} m/s: {} predicts {:.4g} µm ({:.4g} to {:.4g})", velocities[i],
                            c.name, c.diameter_um[i], c.low_um[i], c.high_um[i])));
      }
    }
    text += "\n";
  }
  return sheet.draw(
      "report_next.gp",
      {sheet.table("table", "_rows", rows), sheet.table("curves", "", text),
       sheet.table("points", "_proposed", proposed),
       "names=" + gnuplot_string(fmt::format("{}", fmt::join(names, " "))),
       fmt::format("n_curves={}; next_v={:.9g}; n_rows={}", names.size(), next.velocity_m_s,
                   has(r, KatRow::Kind::critical_diameter) ? 1 : 0),
       definitions(x, "x"), definitions(y, "y")},
      next.velocity_m_s > 0.0
          ? fmt::format("What the leading explanations of {} predict, with one standard deviation, "
                        "and the drop that separates them most: {:.3g} m/s.",
                        r.study.name, next.velocity_m_s)
          : fmt::format("What the leading explanation of {} predicts.", r.study.name));
}

}  // namespace

std::vector<const Candidate*> ranked(const Diagnosis& d) {
  constexpr std::size_t most_pairs = 3;
  std::vector<const Candidate*> list;
  for (const Candidate& c : d.ranking) list.push_back(&c);
  for (std::size_t i = 0; i < std::min(most_pairs, d.pairs.size()); ++i)
    list.push_back(&d.pairs[i]);
  return list;
}

bool same_measurements(const std::vector<std::unique_ptr<StudyResult>>& results) {
  const auto& first = results.front()->observations.list;
  return std::all_of(results.begin(), results.end(), [&](const auto& r) {
    const auto& list = r->observations.list;
    return std::equal(list.begin(), list.end(), first.begin(), first.end(),
                      [](const Observation& a, const Observation& b) {
                        return a.measured == b.measured &&
                               a.row.impact_velocity_m_s == b.row.impact_velocity_m_s;
                      });
  });
}

std::string safe_name(const std::string& name) {
  std::string safe;
  for (const char c : name) {
    const bool ok = std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '-' || c == '+';
    safe += ok ? c : '_';
  }
  return safe.empty() ? "study" : safe;
}

StudyFigures draw_study(const StudyResult& r, const fs::path& folder, const std::string& prefix) {
  StudyFigures figures;
  for (const auto kind : {KatRow::Kind::critical_diameter, KatRow::Kind::retained_share,
                          KatRow::Kind::residual_speed}) {
    const Quantity& quantity = quantity_of(kind);
    if (has(r, kind))
      figures.fit.push_back(draw_fit(r, quantity, Sheet(folder, prefix + "_" + quantity.key)));
  }
  for (const Column& c : columns(r)) {
    figures.residuals.push_back(
        draw_residuals(r, c, Sheet(folder, prefix + "_residuals_" + safe_name(c.name))));
  }
  if (r.diagnosis) {
    figures.ranking = draw_ranking(r, Sheet(folder, prefix + "_ranking"));
    figures.next = draw_next(r, Sheet(folder, prefix + "_next"));
  }
  return figures;
}

Figure draw_staircase(const std::vector<std::unique_ptr<StudyResult>>& results,
                      const fs::path& folder) {
  const Sheet sheet(folder, "staircase");
  ValueRange percent;
  std::vector<std::string> names;
  std::size_t n_dem = 0;
  const bool one_table = same_measurements(results);
  std::string text = "study,name,reduced_percent,dem_percent,hover,dem_hover\n";
  for (const auto& r : results) {
    const double reduced = 100.0 * rms_relative_error(r->comparison.rms);
    const double dem = r->dem ? 100.0 * r->dem->rms_relative_error : NAN;
    if (r->dem) ++n_dem;
    percent.add(reduced);
    percent.add(dem);
    const std::string effects = r->effects().empty() ? "no added effect" : r->effects();
    names.push_back(!one_table             ? safe_name(r->study.name)
                    : r->effects().empty() ? "baseline"
                                           : "+" + safe_name(r->study.effects.back().name));
    text += fmt::format("{},{},{},{},{},{}\n", names.size(), hover_cell(r->study.name),
                        number(reduced), number(dem),
                        hover_cell(fmt::format("{} ({}): {:.2f} % with the reduced model",
                                               r->study.name, effects, reduced)),
                        hover_cell(r->dem ? fmt::format("{} ({}): {:.2f} % with LIGGGHTS",
                                                        r->study.name, effects, dem)
                                          : ""));
  }
  // Of one table; studies of several have a noise each.
  const double noise = one_table ? 100.0 * results.front()->observations.relative_noise() : 0.0;
  percent.add(noise);
  return sheet.draw(
      "report_staircase.gp",
      {sheet.table("table", "", text), fmt::format("studies={}", names.size()),
       "names=" + gnuplot_string(fmt::format("{}", fmt::join(names, " "))),
       fmt::format("n_dem={}; noise={:.9g}; most={:.9g}", n_dem, noise, percent.high)},
      (one_table ? "Error before and after each added effect" : "Error of each study") +
          std::string(": root of the mean square of (model - measured)/measured over all rows."));
}

}  // namespace powderlink::analysis
