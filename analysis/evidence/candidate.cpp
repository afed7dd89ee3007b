// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/evidence/candidate.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "analysis/critical_diameter.h"
#include "analysis/critical_speed.h"
#include "analysis/units.h"
#include "models/effect_registry.h"

namespace powderlink::analysis {

namespace {

constexpr const char* kEnergy = "adhesive_energy_J_m2";
constexpr double kScale = 30.0;        // upper over lower bound of a parameter with a scale
constexpr double kNoiseFreedom = 2.0;  // nu of an assumed noise
constexpr std::size_t kStarts = 3;
constexpr int kEnergies = 25;  // values of the adhesive energy that are tried

/// Where a fitted value goes.
struct Slot {
  int effect = -1;  ///< position in the hypothesis; -1 is the adhesive energy
  std::size_t parameter = 0;
  bool of_added = false;
  double plausible_lower = 0.0, plausible_upper = 0.0;
};

/// Decades that a value is outside its plausible range.
double decades_off(double value, const Slot& slot) {
  if (value > slot.plausible_upper && slot.plausible_upper > 0.0)
    return std::log10(value / slot.plausible_upper);
  if (value < slot.plausible_lower)
    return std::log10(slot.plausible_lower / std::max(value, 1e-300));
  return 0.0;
}

struct Setting {
  Hypothesis hypothesis;
  std::vector<Slot> slots;
  FitProblem problem;
  bool calibrated = false;  ///< estimates, corrected by the integration where the fit is
};

void apply(Hypothesis& h, const std::vector<Slot>& slots, const std::vector<double>& values) {
  for (std::size_t i = 0; i < slots.size(); ++i) {
    if (slots[i].effect < 0)
      h.adhesive_energy_J_m2 = values[i];
    else
      h.effects[static_cast<std::size_t>(slots[i].effect)].parameters[slots[i].parameter] =
          values[i];
  }
}

void add_slot(Setting& s, Slot slot, const std::string& name, double lower, double upper,
              double start) {
  s.slots.push_back(slot);
  const bool scale = lower > 0.0 && upper > kScale * lower;
  s.problem.parameters.push_back({name, lower, upper, start, scale});
}

void define_residuals(Setting& s, const Study& study, const Observations& observations) {
  s.problem.residuals = [&study, &observations, hypothesis = s.hypothesis,
                         slots = s.slots](const std::vector<double>& values) {
    Hypothesis h = hypothesis;
    apply(h, slots, values);
    std::vector<double> r;
    r.reserve(observations.list.size());
    for (const Observation& o : observations.list)
      r.push_back(residual(o, predicted(study, h, o.row)));
    return r;
  };
  s.problem.prior = [slots = s.slots](const std::vector<double>& values) {
    std::vector<double> r;
    r.reserve(slots.size());
    for (std::size_t j = 0; j < slots.size(); ++j) r.push_back(decades_off(values[j], slots[j]));
    return r;
  };
}

Setting make_setting(const Study& study, const Observations& observations,
                     const std::vector<std::string>& added) {
  Setting s;
  s.hypothesis.effects = study.effects;
  s.hypothesis.estimated = added.size() > 1;
  const EnergyRange& energy = study.adhesive_energy;
  s.hypothesis.adhesive_energy_J_m2 = std::sqrt(energy.lower_J_m2 * energy.upper_J_m2);
  const bool of_rows = study.rows.front().adhesive_energy_J_m2.has_value();
  if (!of_rows && !energy.fixed()) {
    add_slot(s, {-1, 0, false, 0.0, kPlausibleEnergy_J_m2}, kEnergy, energy.lower_J_m2,
             energy.upper_J_m2, s.hypothesis.adhesive_energy_J_m2);
  }
  for (std::size_t e = 0; e < study.effects.size(); ++e) {
    const auto& info = *models::find_effect(study.effects[e].name).info;
    for (const FreeRange& range : study.effects[e].free) {
      if (given_by_rows(study, study.effects[e].name, range.parameter)) continue;
      const models::EffectParameter& p = info.parameters[range.parameter];
      add_slot(s,
               {static_cast<int>(e), range.parameter, false, p.plausible_lower, p.plausible_upper},
               p.name, range.lower, range.upper, study.effects[e].parameters[range.parameter]);
    }
  }
  for (const std::string& name : added) {
    const auto& info = *models::find_effect(name).info;
    EffectChoice choice{name, {}};
    for (std::size_t i = 0; i < info.parameters.size(); ++i) {
      const models::EffectParameter& p = info.parameters[i];
      choice.parameters.push_back(p.typical);
      if (given_by_rows(study, name, i)) continue;
      add_slot(s,
               {static_cast<int>(s.hypothesis.effects.size()), i, true, p.plausible_lower,
                p.plausible_upper},
               p.name, p.lower, p.upper, p.typical);
    }
    s.hypothesis.effects.push_back(choice);
  }
  define_residuals(s, study, observations);
  return s;
}

double chi2_of(const std::vector<double>& r) {
  double sum = 0.0;
  for (const double x : r) sum += x * x;
  return sum;
}

/// The adhesive energy that suits the other values: d_c grows with nearly its first power.
std::pair<std::vector<double>, double> suit_energy(const Setting& s, const Observations& all,
                                                   std::vector<double> values, int turns) {
  constexpr double power = 0.8;
  constexpr double good = 0.02;  // of ln d
  std::vector<double> r = s.problem.residuals(values);
  if (s.slots.empty() || s.slots[0].effect >= 0) return {values, chi2_of(r)};
  double best = chi2_of(r);
  std::vector<double> best_values = values;
  for (int turn = 0; turn < turns; ++turn) {
    double mean = 0.0;
    double weight = 0.0;
    for (std::size_t i = 0; i < r.size(); ++i) {
      constexpr double smallest = 1e-3;  // of d_model/d_measured
      const double sigma = all.list[i].sigma;
      mean += std::log(std::max(1.0 + r[i] * sigma, smallest)) / (sigma * sigma);
      weight += 1.0 / (sigma * sigma);
    }
    mean /= weight;
    if (std::fabs(mean) < good) break;
    const FitParameter& p = s.problem.parameters[0];
    values[0] = std::clamp(values[0] * std::exp(-mean / power), p.lower, p.upper);
    r = s.problem.residuals(values);
    const double chi2 = chi2_of(r);
    if (chi2 < best) {
      best = chi2;
      best_values = values;
    }
  }
  return {best_values, best};
}

std::vector<double> grid_of(const FitParameter& p, double from, double to, int points) {
  std::vector<double> grid;
  grid.reserve(static_cast<std::size_t>(points));
  const double low = p.to_coordinate(std::clamp(from, p.lower, p.upper));
  const double high = p.to_coordinate(std::clamp(to, p.lower, p.upper));
  for (int i = 0; i < points; ++i)
    grid.push_back(
        std::clamp(p.to_value(low + (high - low) * i / std::max(1, points - 1)), p.lower, p.upper));
  return grid;
}

/// Every point of the grid with every value of one more coordinate.
void append_axis(std::vector<std::vector<double>>& grid, const std::vector<double>& values) {
  std::vector<std::vector<double>> product;
  for (const auto& head : grid) {
    for (const double v : values) {
      product.push_back(head);
      product.back().push_back(v);
    }
  }
  grid = std::move(product);
}

bool diameters_only(const Study& study) {
  return std::all_of(study.rows.begin(), study.rows.end(), [](const KatRow& row) {
    return row.kind() == KatRow::Kind::critical_diameter;
  });
}

bool cheap(const Study& study, const Hypothesis& h) {
  for (const KatRow& row : study.rows) {
    const ReducedModel model(row_setup(study, h.effects, row, 1.0));
    if (!CriticalSpeed(model, h.estimated).available()) return false;
  }
  return true;
}

/// Hypothesis::correction at these values.
std::map<double, double> correction_at(const Study& study, const Setting& s,
                                       const std::vector<double>& values) {
  constexpr double tolerance = 3e-4;  // of d_c
  Hypothesis h = s.hypothesis;
  apply(h, s.slots, values);
  std::map<double, double> correction;
  for (const KatRow& row : study.rows) {
    const double v = row.impact_velocity_m_s;
    if (row.kind() == KatRow::Kind::residual_speed || correction.count(v) > 0) continue;
    const ReducedModel model(row_setup(study, h.effects, row,
                                       row.adhesive_energy_J_m2.value_or(h.adhesive_energy_J_m2)));
    const CriticalDiameter integrated = critical_diameter(model, v, tolerance);
    const CriticalDiameter estimate = quick_critical_diameter(model, v, true);
    const bool both = integrated.found() && estimate.found();
    correction[v] = both ? std::log(integrated.diameter_m / estimate.diameter_m) : 0.0;
  }
  return correction;
}

/// Do corrected estimates change with Gamma as the integration does?
bool follows_energy(const Study& study, const Setting& s, std::vector<double> values) {
  constexpr double step = 0.1;       // of ln Gamma
  constexpr double of_slope = 0.12;  // of dln d_c/dln Gamma, which is 0.5 to 1 where Gamma counts
  if (s.slots.empty() || s.slots[0].effect >= 0) return true;
  const FitParameter& p = s.problem.parameters[0];
  values[0] *= std::exp(values[0] * std::exp(step) < p.upper ? step : -step);
  const std::map<double, double> moved = correction_at(study, s, values);
  return std::all_of(moved.begin(), moved.end(), [&](const auto& m) {
    return std::fabs(m.second - s.hypothesis.correction.at(m.first)) < of_slope * step;
  });
}

/// Least squares; with a calibrated setting until the estimates are those of the integration there, and
/// by integration from there on when estimates do not follow it.
FitSolution solve(Setting& s, const std::vector<std::vector<double>>& starts, const Study& study,
                  const Observations& observations) {
  constexpr int most_turns = 4;
  constexpr double settled = 1e-3;  // of d_c: the accuracy of all that is quick
  FitSolution solution = least_squares(s.problem, starts);
  for (int turn = 0; s.calibrated && turn < most_turns; ++turn) {
    const std::map<double, double> before = s.hypothesis.correction;
    s.hypothesis.correction = correction_at(study, s, solution.values);
    double change = before.empty() ? 1.0 : 0.0;
    for (const auto& [v, was] : before)
      change = std::max(change, std::fabs(s.hypothesis.correction.at(v) - was));
    if (change < settled) break;
    define_residuals(s, study, observations);
    solution = least_squares(s.problem, solution.values);
  }
  if (s.calibrated && !follows_energy(study, s, solution.values)) {
    s.calibrated = s.hypothesis.estimated = false;
    s.hypothesis.correction.clear();
    define_residuals(s, study, observations);
    solution = least_squares(s.problem, solution.values);
  }
  return solution;
}

/// The best points of a grid over the effects' parameters.
std::vector<std::vector<double>> searched_starts(const Study& study, const Setting& s,
                                                 const Observations& observations) {
  const bool fast = cheap(study, s.hypothesis);
  const int turns = fast ? 8 : 4;
  std::size_t scanned = 0;
  for (const Slot& slot : s.slots) scanned += slot.effect >= 0 ? 1 : 0;
  const bool few = !fast || !diameters_only(study);
  const int points = scanned <= 1 ? (few ? 9 : 31) : (few ? 4 : 7);
  std::vector<std::vector<double>> grid = {{}};
  for (std::size_t j = 0; j < s.slots.size(); ++j) {
    const FitParameter& p = s.problem.parameters[j];
    std::vector<double> values = {p.start};
    // Shares and speeds say nothing about Gamma while every grain stays or every grain leaves.
    if (s.slots[j].effect < 0 && !diameters_only(study))
      values = grid_of(p, p.lower, p.upper, kEnergies);
    if (s.slots[j].effect >= 0) values = grid_of(p, p.lower, p.upper, p.logarithmic ? points : 2);
    append_axis(grid, values);
  }
  std::vector<std::pair<double, std::vector<double>>> found;
  for (const auto& values : grid) {
    auto [suited, chi2] = suit_energy(s, observations, values, turns);
    found.emplace_back(chi2, suited);
  }
  std::stable_sort(found.begin(), found.end(),
                   [](const auto& a, const auto& b) { return a.first < b.first; });
  std::vector<std::vector<double>> starts;
  for (std::size_t i = 0; i < std::min(kStarts, found.size()); ++i)
    starts.push_back(found[i].second);
  return starts;
}

/// From explanations that share effects with this one; what they do not know varies over its range.
std::vector<std::vector<double>> near_starts(const Setting& s, const Observations& observations,
                                             const std::vector<const Candidate*>& near) {
  std::vector<std::pair<double, std::vector<double>>> found;
  constexpr int points = 4;
  for (const Candidate* c : near) {
    std::vector<std::vector<double>> grid = {{}};
    for (std::size_t j = 0; j < s.slots.size(); ++j) {
      const FitParameter& p = s.problem.parameters[j];
      const ParameterEstimate* known = c->find(p.name);
      std::vector<double> values = {known != nullptr ? known->value : p.start};
      if (known == nullptr && s.slots[j].effect >= 0) {
        values =
            p.logarithmic ? grid_of(p, p.lower, p.upper, points + 2) : std::vector<double>{p.start};
        if (p.logarithmic) values = {values.begin() + 1, values.end() - 1};
      }
      append_axis(grid, values);
    }
    for (const auto& values : grid) {
      auto [suited, chi2] = suit_energy(s, observations, values, 3);
      found.emplace_back(chi2, suited);
    }
  }
  std::stable_sort(found.begin(), found.end(),
                   [](const auto& a, const auto& b) { return a.first < b.first; });
  std::vector<std::vector<double>> starts;
  for (std::size_t i = 0; i < std::min<std::size_t>(2, found.size()); ++i)
    starts.push_back(found[i].second);
  return starts;
}

/// Holds parameters of added effects at their typical values while BIC does not rise.
void hold_what_is_not_needed(Setting& s, FitSolution& solution, const Study& study,
                             const Observations& observations) {
  const double per_parameter = std::log(static_cast<double>(observations.list.size()));
  for (std::size_t j = s.slots.size(); j-- > 0;) {
    if (!s.slots[j].of_added) continue;
    Setting less = s;
    std::vector<double> start = solution.values;
    apply(less.hypothesis, {s.slots[j]}, {s.problem.parameters[j].start});
    less.slots.erase(less.slots.begin() + static_cast<long>(j));
    less.problem.parameters.erase(less.problem.parameters.begin() + static_cast<long>(j));
    start.erase(start.begin() + static_cast<long>(j));
    define_residuals(less, study, observations);
    FitSolution held =
        less.slots.empty()
            ? least_squares(less.problem, start)
            : solve(less, {suit_energy(less, observations, start, 8).first}, study, observations);
    const double worse = score(observations, held.chi2) + held.prior -
                         score(observations, solution.chi2) - solution.prior;
    if (worse > per_parameter) continue;
    s = std::move(less);
    solution = std::move(held);
  }
}

/// An implausible fit whose Gamma lies at a bound that the study set within the plausible range: with a
/// wider bound it might look otherwise.
void mark_bound_of_study(Candidate& c, const Study& study) {
  constexpr double margin = 1.001;
  const EnergyRange& bounds = study.adhesive_energy;
  const bool implausible = std::any_of(c.parameters.begin(), c.parameters.end(),
                                       [](const ParameterEstimate& p) { return !p.plausible(); });
  if (!implausible || bounds.fixed() || bounds.upper_J_m2 >= kPlausibleEnergy_J_m2) return;
  for (ParameterEstimate& p : c.parameters) {
    if (p.effect.empty() && p.role == ParameterEstimate::Role::fitted)
      p.at_bound = p.at_bound || p.value * margin >= bounds.upper_J_m2;
  }
}

void judge_plausibility(Candidate& c) {
  std::vector<std::string> reasons;
  for (const ParameterEstimate& p : c.parameters) {
    if (!p.plausible()) {
      reasons.push_back(fmt::format("{} = {:.3g} {} is outside {:g} to {:g} ({})", p.name, p.value,
                                    unit_of(p.name), p.plausible_lower, p.plausible_upper,
                                    p.source));
    }
    if (p.at_bound)
      reasons.push_back(fmt::format("{} stopped at a bound, {:.3g}", p.name, p.value));
    c.plausible = c.plausible && p.plausible();
  }
  c.why = reasons.empty() ? "all parameters are within their plausible ranges"
                          : fmt::format("{}", fmt::join(reasons, "; "));
}

void list_parameters(Candidate& c, const Setting& s, const Study& study) {
  const auto slot_of = [&](int effect, std::size_t parameter) -> std::optional<std::size_t> {
    for (std::size_t j = 0; j < s.slots.size(); ++j) {
      if (s.slots[j].effect == effect && (effect < 0 || s.slots[j].parameter == parameter))
        return j;
    }
    return std::nullopt;
  };
  const auto fitted = [&](ParameterEstimate& p, std::size_t j) {
    p.role = ParameterEstimate::Role::fitted;
    p.lower = s.problem.parameters[j].lower;
    p.upper = s.problem.parameters[j].upper;
    p.at_bound = c.solution.at_bound[j];
  };
  if (!study.rows.front().adhesive_energy_J_m2) {
    ParameterEstimate p;
    p.name = kEnergy;
    p.value = c.hypothesis.adhesive_energy_J_m2;
    p.plausible_upper = kPlausibleEnergy_J_m2;
    p.source = "work of adhesion of dry solids, 0.01 to 1 J/m^2 as a rule";
    if (const auto j = slot_of(-1, 0)) fitted(p, *j);
    c.parameters.push_back(p);
  }
  for (std::size_t e = 0; e < c.hypothesis.effects.size(); ++e) {
    const EffectChoice& choice = c.hypothesis.effects[e];
    const auto& info = *models::find_effect(choice.name).info;
    for (std::size_t i = 0; i < info.parameters.size(); ++i) {
      if (given_by_rows(study, choice.name, i)) continue;
      const models::EffectParameter& known = info.parameters[i];
      ParameterEstimate p;
      p.name = known.name;
      p.effect = choice.name;
      p.value = choice.parameters[i];
      p.plausible_lower = known.plausible_lower;
      p.plausible_upper = known.plausible_upper;
      p.source = known.source;
      if (const auto j = slot_of(static_cast<int>(e), i))
        fitted(p, *j);
      else if (e >= study.effects.size())
        p.role = ParameterEstimate::Role::held;
      c.parameters.push_back(p);
    }
  }
}

double rms(const std::vector<double>& relative) {
  double sum = 0.0;
  for (const double e : relative) sum += e * e;
  return std::sqrt(sum / static_cast<double>(relative.size()));
}

}  // namespace

double score(const Observations& o, double chi2) {
  if (o.noise.known()) return chi2;
  const double n = static_cast<double>(o.list.size());
  return (n + kNoiseFreedom) * std::log1p(chi2 / kNoiseFreedom);
}

std::vector<TrendTest> residual_tests(const Study& study, const Observations& o,
                                      const std::vector<double>& residuals, int fitted) {
  std::vector<double> velocity;
  std::vector<double> contact_time;
  for (const KatRow& row : study.rows) {
    velocity.push_back(row.impact_velocity_m_s);
    if (row.contact_time_us) contact_time.push_back(*row.contact_time_us);
  }
  std::vector<TrendTest> tests;
  const std::string v = "impact_velocity_m_s";
  if (o.noise.known()) {
    tests.push_back({v, "scatter", scatter_p_value(residuals, fitted)});
  }
  tests.push_back({v, "curve", curve_p_value(velocity, residuals, o.noise.known())});
  tests.push_back({v, "rank", rank_p_value(velocity, residuals)});
  tests.push_back({v, "runs", runs_p_value(velocity, residuals)});
  if (study.rows.front().diameter_um) {
    std::vector<double> diameter;
    for (const KatRow& row : study.rows) diameter.push_back(row.diameter_um.value_or(0.0));
    if (*std::min_element(diameter.begin(), diameter.end()) > 0.0)
      tests.push_back({"diameter_um", "curve", curve_p_value(diameter, residuals, true)});
  }
  if (contact_time.size() == velocity.size())
    tests.push_back({"contact_time_us", "rank", rank_p_value(contact_time, residuals)});
  for (const auto& [name, first] : study.rows.front().other) {
    std::vector<double> column;
    for (const KatRow& row : study.rows) column.push_back(row.other.at(name));
    // May have been computed from the diameter itself: told, but no evidence.
    tests.push_back({name, "rank", rank_p_value(column, residuals), 1.0, false});
  }
  correct_for_number(tests);
  return tests;
}

bool residuals_fail(const std::vector<TrendTest>& tests, const std::vector<double>& residuals,
                    const Noise& noise) {
  const double mean_square = chi2_of(residuals) / static_cast<double>(residuals.size());
  return least_p_value(tests) < kAlarm ||
         (!noise.known() && mean_square > kRmsOverAssumed * kRmsOverAssumed);
}

double Candidate::chi2_per_dof() const {
  const int degrees = static_cast<int>(predicted.size()) - fitted();
  return degrees > 0 ? solution.chi2 / degrees : std::numeric_limits<double>::quiet_NaN();
}

const ParameterEstimate* Candidate::find(const std::string& wanted) const {
  for (const ParameterEstimate& p : parameters) {
    if (p.name == wanted) return &p;
  }
  return nullptr;
}

bool Candidate::at_bound() const {
  return std::any_of(parameters.begin(), parameters.end(),
                     [](const ParameterEstimate& p) { return p.at_bound; });
}

namespace {

/// \param s  its bounds may be narrower than the registry's
Candidate fit(const Study& study, const Observations& observations, Setting s,
              const std::vector<std::string>& added, const std::vector<const Candidate*>& near) {
  const std::size_t n = observations.list.size();
  Candidate c;
  c.added = added;
  c.name = added.empty() ? "none" : fmt::format("{}", fmt::join(added, "+"));
  // Effects on top of others: estimates are searched and corrected, as integrating takes minutes.
  if (Hypothesis estimates = s.hypothesis; !estimates.estimated && !cheap(study, estimates)) {
    estimates.estimated = true;
    s.calibrated = cheap(study, estimates);
    if (s.calibrated) s.hypothesis = estimates;
    define_residuals(s, study, observations);
  }
  const auto starts =
      near.empty() ? searched_starts(study, s, observations) : near_starts(s, observations, near);
  c.solution = solve(s, starts, study, observations);
  hold_what_is_not_needed(s, c.solution, study, observations);

  c.hypothesis = s.hypothesis;
  apply(c.hypothesis, s.slots, c.solution.values);
  c.problem = s.problem;
  list_parameters(c, s, study);
  std::vector<double> relative;
  std::vector<double> left_out;
  const std::vector<double> loo = leave_one_out(c.solution);
  for (std::size_t i = 0; i < n; ++i) {
    const Observation& o = observations.list[i];
    c.predicted.push_back(predicted(study, c.hypothesis, o.row));
    relative.push_back(o.error(c.predicted.back()));
    left_out.push_back(loo[i] * o.sigma);
  }
  c.rms_relative_error = rms(relative);
  c.loo_rms_relative_error = rms(left_out);
  c.bic = score(observations, c.solution.chi2) + c.solution.prior +
          c.fitted() * std::log(static_cast<double>(n));
  c.tests = residual_tests(study, observations, c.solution.residuals, c.fitted());
  mark_bound_of_study(c, study);
  judge_plausibility(c);
  return c;
}

}  // namespace

Candidate fit_candidate(const Study& study, const Observations& observations,
                        const std::vector<std::string>& added,
                        const std::vector<const Candidate*>& near) {
  Setting s = make_setting(study, observations, added);
  const std::size_t n = observations.list.size();
  if (s.slots.size() > n) {
    throw InvalidInput(study.file.string(),
                       fmt::format("{} free parameters and {} rows", s.slots.size(), n),
                       "at least as many rows as free parameters",
                       "measure at more velocities, or fix parameters");
  }
  Candidate free = fit(study, observations, s, added, near);
  if (free.plausible || added.size() != 1) return free;
  for (std::size_t j = 0; j < s.slots.size(); ++j) {
    FitParameter& p = s.problem.parameters[j];
    const ParameterEstimate& known = *free.find(p.name);
    p.lower = std::max(p.lower, known.plausible_lower);
    p.upper = std::min(p.upper, known.plausible_upper);
    if (!(p.lower < p.upper)) return free;
    p.start = std::clamp(p.start, p.lower, p.upper);
  }
  Candidate plausible = fit(study, observations, s, added, near);
  return plausible.bic <= free.bic + kApart ? plausible : free;
}

}  // namespace powderlink::analysis
