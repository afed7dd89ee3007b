// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/kat/experiment/kat_analysis.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "analysis/kat/study/checks.h"

namespace powderlink::analysis {

namespace {

constexpr double kLeast = 0.05;  // of a value: the low end of an interval that reaches 0

/// The drop with `value` at both ends; nothing when it is exact.
template <class Set>
void vary(UncertainDrop& drop, double value, double sigma, const Set& set) {
  if (!(sigma > 0.0)) return;
  UncertainDrop::Ends ends{drop.best, drop.best};
  set(ends.low, std::max(kLeast * value, value - kNormal95 * sigma));
  set(ends.high, value + kNormal95 * sigma);
  drop.ends.push_back(std::move(ends));
}

}  // namespace

UncertainDrop uncertain_drop(const KatAnalysisInput& in, const Estimate& critical_um) {
  UncertainDrop drop{in.drop, {}};
  drop.best.critical_diameter_m = 1e-6 * critical_um.value;
  UncertainDrop::Ends critical{drop.best, drop.best};
  critical.low.critical_diameter_m = 1e-6 * critical_um.low;
  critical.high.critical_diameter_m = 1e-6 * critical_um.high;
  drop.ends.push_back(std::move(critical));
  vary(drop, in.drop.impact_velocity_m_s, in.velocity_sigma_m_s,
       [](KatDrop& d, double x) { d.impact_velocity_m_s = x; });
  if (in.drop.contact_time_s) {
    vary(drop, *in.drop.contact_time_s, in.contact_time_sigma_s,
         [](KatDrop& d, double x) { d.contact_time_s = x; });
  }
  if (in.drop.deceleration_m_s2) {
    vary(drop, *in.drop.deceleration_m_s2, in.deceleration_sigma_m_s2,
         [](KatDrop& d, double x) { d.deceleration_m_s2 = x; });
  }
  return drop;
}

std::vector<MethodResult> all_methods(const UncertainDrop& drop) {
  std::vector<MethodResult> results;
  for (const GammaMethod& m : gamma_methods()) results.push_back({m.info, m.estimate(drop)});
  return results;
}

std::vector<std::string> disagreements(const std::vector<MethodResult>& methods) {
  std::vector<const MethodResult*> given;
  for (const MethodResult& m : methods)
    if (m.gamma) given.push_back(&m);
  std::sort(given.begin(), given.end(), [](const MethodResult* a, const MethodResult* b) {
    return a->gamma->value < b->gamma->value;
  });
  bool apart = false;
  std::vector<std::string> list;
  for (const MethodResult* m : given) {
    list.push_back(fmt::format("{} {:.3g} J/m^2", m->info->label, m->gamma->value));
    for (const MethodResult* other : given) apart = apart || m->gamma->high < other->gamma->low;
  }
  if (!apart) return {};
  return {
      fmt::format("the methods disagree by up to a factor of {:.3g}, "
                  "more than their intervals allow ({}): their assumptions cannot hold together; "
                  "believe the one whose assumption was measured",
                  given.back()->gamma->value / given.front()->gamma->value, fmt::join(list, ", "))};
}

KatAnalysis analyse_kat(const KatAnalysisInput& in) {
  KatAnalysis a;
  a.retention = analyse_retention(in.before_um, in.after_um, in.retention);
  if (in.digits_um2 > 0.0) {
    for (Estimate* e : {&a.retention.critical, &a.retention.truncation, &a.retention.half_point,
                        &a.retention.largest_remaining}) {
      e->low -= in.digits_um2 / e->low;
      e->high += in.digits_um2 / e->high;
    }
  }
  a.drop = uncertain_drop(in, a.retention.critical);
  a.methods = all_methods(a.drop);
  a.warnings = a.retention.warnings;
  const MethodResult* highest = nullptr;
  for (const MethodResult& m : a.methods) {
    if (!m.gamma) continue;
    a.warnings.insert(a.warnings.end(), m.gamma->warnings.begin(), m.gamma->warnings.end());
    if (highest == nullptr || m.gamma->value > highest->gamma->value) highest = &m;
  }
  const std::string high = adhesive_energy_warning(highest->gamma->value, highest->info->label);
  if (!high.empty()) a.warnings.push_back(high);
  for (const std::string& text : disagreements(a.methods)) a.warnings.push_back(text);
  return a;
}

}  // namespace powderlink::analysis
