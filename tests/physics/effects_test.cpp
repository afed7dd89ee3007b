// SPDX-License-Identifier: GPL-3.0-or-later
// Every effect of the registry against its closed form; an effect without a check fails.
#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <set>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <boost/math/quadrature/gauss_kronrod.hpp>

#include "physics/contact/jkr_law.h"
#include "physics/effects/effect_registry.h"
#include "physics/kat/kat_theory.h"
#include "tests/physics/refuses.h"

namespace powderlink {
namespace {

using physics::Effect;
using physics::effect_registry;
using physics::EffectEntry;
using physics::EffectParameter;
using physics::make_effect;
using test::refuses;

constexpr double kPi = physics::JkrLaw::kPi;
constexpr double kRounding = 1e-12;
constexpr double kQuadrature = 1e-10;
constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kRadius = 25e-6;

/// -dU/dh by a central difference; its error is of third order in h/length: 1e-8 for h = 1e-4
/// lengths.
constexpr double kDifference = 1e-7;
double slope_of_energy(const Effect& e, double gap, double length) {
  const double h = 1e-4 * length;
  return -(e.gap_energy_J(gap + h, kRadius) - e.gap_energy_J(gap - h, kRadius)) / (2 * h);
}

void check_finite_stop_pulse() {
  const auto e = make_effect("finite_stop_pulse", {8e-5, 0.3});
  const auto stop = e->stop();
  ASSERT_TRUE(stop.has_value());
  EXPECT_EQ(stop->shape(), physics::StopPulse::Shape::half_sine);
  EXPECT_EQ(stop->duration_s(), 8e-5);
  EXPECT_EQ(stop->rebound(), 0.3);
  const double peak = kPi * 2.0 * 1.3 / (2 * 8e-5);
  EXPECT_NEAR(stop->peak_deceleration_m_s2(2.0), peak, kRounding * peak);
  // Slow limit: d_c ~ v^(-1/2), because the deceleration is proportional to v.
  const auto d = [&](double v) {
    return physics::critical_diameter_slow_m(0.09, 2510.0, stop->peak_deceleration_m_s2(v));
  };
  EXPECT_NEAR(std::log(d(4.0) / d(1.0)) / std::log(4.0), -0.5, kRounding);
  // A rebound alone is still an instant stop.
  const auto kick = make_effect("finite_stop_pulse", {0.0, 0.5})->stop();
  ASSERT_TRUE(kick.has_value());
  EXPECT_EQ(kick->kick_m_s(2.0), 3.0);
}

void check_rate_dependent_adhesion() {
  // Steady peeling at energy release rate G runs at v = v* (G/Gamma - 1)^(1/n).
  for (const double exponent : {0.1, 0.6, 1.0, 2.0}) {
    const double v_star = 0.02;
    const auto e = make_effect("rate_dependent_adhesion", {v_star, exponent});
    EXPECT_TRUE(e->rate_dependent());
    double last = 1.0;
    for (const double ratio : {1.1, 1.5, 2.0, 5.0}) {
      const double v = v_star * std::pow(ratio - 1, 1 / exponent);
      const double factor = e->fracture_energy_factor(v);
      EXPECT_NEAR(factor, ratio, kRounding * ratio);
      EXPECT_GT(factor, last) << "must grow with the speed";
      last = factor;
    }
    EXPECT_NEAR(e->fracture_energy_factor(v_star), 2.0, kRounding) << "v* doubles it";
    EXPECT_EQ(e->fracture_energy_factor(0.0), 1.0);
    EXPECT_EQ(e->fracture_energy_factor(-1.0), 1.0) << "an advancing edge dissipates nothing here";
  }
}

void check_electrostatic_image_force() {
  const double sigma = 3e-5, eps0 = 8.8541878128e-12, density = 2510.0;
  const auto e = make_effect("electrostatic_image_force", {sigma});
  for (const double gap : {0.0, 1e-7, 1e-5, 1e-4}) {
    const double force = e->gap_force_N(gap, kRadius);
    EXPECT_NEAR(force, slope_of_energy(*e, gap, kRadius), kDifference * std::fabs(force));
    // Coulomb's law between the charge and its image at twice the distance of the centre.
    const double charge = sigma * 4 * kPi * kRadius * kRadius;
    const double coulomb = charge * charge / (4 * kPi * eps0 * std::pow(2 * (kRadius + gap), 2));
    EXPECT_NEAR(force, -coulomb, kRounding * coulomb);
  }
  EXPECT_EQ(e->range_m(kRadius), kInfinity);
  EXPECT_FALSE(e->formed_by_touch());
  const double far = 1e6 * kRadius;
  EXPECT_LT(std::fabs(e->gap_energy_J(far, kRadius)),
            1.1e-6 * std::fabs(e->gap_energy_J(0.0, kRadius)));
  // Escape speed from contact, the same at every size.
  for (const double radius : {1e-6, 25e-6, 1e-3}) {
    const double v2 = -2 * e->gap_energy_J(0.0, radius) / physics::sphere_mass_kg(radius, density);
    const double expected = 3 * sigma * sigma / (2 * density * eps0);
    EXPECT_NEAR(v2, expected, kRounding * expected);
  }
}

void check_capillary_bridge() {
  const double tension = 0.05, kappa = 0.08;
  const auto e = make_effect("capillary_bridge", {tension, kappa});
  const double rupture = kappa * kRadius;
  EXPECT_NEAR(e->range_m(kRadius), rupture, kRounding * rupture);
  EXPECT_TRUE(e->formed_by_touch());
  const double closed = 4 * kPi * kRadius * tension;
  EXPECT_NEAR(e->gap_force_N(0.0, kRadius), -closed, kRounding * closed)
      << "full wetting at contact";
  EXPECT_NEAR(e->gap_force_N(-1e-8, kRadius), -closed, kRounding * closed) << "constant in overlap";
  EXPECT_LT(e->gap_force_N(rupture, kRadius), 0.0) << "still pulls just before rupture";
  EXPECT_EQ(e->gap_force_N(rupture * (1 + 1e-9), kRadius), 0.0);
  EXPECT_EQ(e->gap_energy_J(rupture * (1 + 1e-9), kRadius), 0.0);

  const double volume = std::pow(rupture, 3);  // rupture at the cube root of the volume
  for (const double share : {0.0, 0.05, 0.3, 0.9}) {
    const double gap = share * rupture;
    const auto force = [&](double h) { return e->gap_force_N(h, kRadius); };
    const double work = boost::math::quadrature::gauss_kronrod<double, 61>::integrate(
        force, gap, rupture, 10, kQuadrature);
    const double depth = std::fabs(e->gap_energy_J(0.0, kRadius));
    EXPECT_NEAR(e->gap_energy_J(gap, kRadius), work, 10 * kQuadrature * depth) << share;
    // The force tells the height H of the meniscus: F = -(2 gamma/H) 2 pi R (H - h). The liquid
    // between plate and parabola within the wetted radius must be the whole volume.
    const double height = gap / (1 + force(gap) / closed);
    if (share > 0.0) {
      const double wetted = std::sqrt(2 * kRadius * (height - gap));
      const double liquid = boost::math::quadrature::gauss_kronrod<double, 15>::integrate(
          [&](double r) { return 2 * kPi * r * (gap + r * r / (2 * kRadius)); }, 0.0, wetted);
      // 1 + F/F(0) loses digits while the gap is a small part of H.
      EXPECT_NEAR(liquid, volume, 1e-9 * volume) << share;
    }
  }
  const double inside = -2e-8;
  EXPECT_NEAR(e->gap_energy_J(inside, kRadius), e->gap_energy_J(0.0, kRadius) + closed * inside,
              kRounding * closed * rupture);
  EXPECT_NEAR(e->gap_force_N(0.4 * rupture, kRadius), slope_of_energy(*e, 0.4 * rupture, rupture),
              kDifference * closed);
}

void check_surface_roughness() {
  for (const double asperity : {1e-8, 1e-6, 1e-3}) {
    const auto e = make_effect("surface_roughness", {asperity});
    for (const double radius : {1e-7, kRadius, 1e-3}) {
      // Pull-off of sphere and asperity in series: 1/R' = 1/R + 1/r_a.
      const double in_series = 1 / (1 / radius + 1 / asperity);
      const double factor = e->adhesion_factor(radius);
      EXPECT_NEAR(factor * radius, in_series, kRounding * in_series);
      EXPECT_GT(factor, 0.0);
      EXPECT_LT(factor, 1.0);
    }
  }
  // Limits: smooth when the asperity is large, the asperity alone when it is small.
  EXPECT_NEAR(make_effect("surface_roughness", {1e-2})->adhesion_factor(1e-8), 1.0, 1e-6);
  EXPECT_NEAR(make_effect("surface_roughness", {1e-9})->adhesion_factor(1e-3) * 1e-3, 1e-9, 1e-15);
}

void check_plastic_contact() {
  const physics::JkrLaw law(5.6e10, 90.0);
  const double a0 = law.equilibrium_contact_radius_m(kRadius);
  const double load = 6 * kPi * law.work_of_adhesion_J_m2() * kRadius;  // apparent, at rest
  const double pressure = load / (kPi * a0 * a0);
  const double hertz = 4.0 / 3.0 * law.effective_modulus_Pa() * a0 * a0 * a0 / load;
  EXPECT_NEAR(hertz, kRadius, 1e-9 * kRadius) << "JKR at rest is Hertz at the apparent load";
  for (const double share : {0.2, 0.5, 0.9}) {
    // The flattened contact carries the load at the yield pressure, and Hertz's law for that load
    // gives the radius of curvature that has this contact radius.
    const double yield = share * pressure;
    const double a = std::sqrt(load / (kPi * yield));
    const double flattened = 4.0 / 3.0 * law.effective_modulus_Pa() * a * a * a / load;
    const double factor = make_effect("plastic_contact", {yield})->flattening_factor(law, kRadius);
    EXPECT_NEAR(factor * kRadius / flattened, 1.0, 1e-9);
  }
  EXPECT_EQ(make_effect("plastic_contact", {1.01 * pressure})->flattening_factor(law, kRadius),
            1.0);
  // Small grains yield first: p ~ R^(-1/3), the factor ~ R^(-1/2).
  const auto e = make_effect("plastic_contact", {0.1 * pressure});
  const double ratio = e->flattening_factor(law, kRadius / 4) / e->flattening_factor(law, kRadius);
  EXPECT_NEAR(ratio, 2.0, 1e-9);
  EXPECT_EQ(e->flattening_factor(physics::JkrLaw(5.6e10, 0.0), kRadius), 1.0);
}

void check_psd_cutoff() {
  const double q = 6.0;
  const auto e = make_effect("psd_cutoff", {60.0, q});
  for (const double d : {20e-6, 59e-6, 60e-6, 200e-6}) {
    const double seen = e->observed_diameter_m(d);
    const double sum = std::pow(d / seen, -q) + std::pow(60e-6 / seen, -q);
    EXPECT_NEAR(sum, 1.0, 1e-9) << d;
  }
  // A sharp cut is the smaller of the two.
  const auto sharp = make_effect("psd_cutoff", {60.0, kInfinity});
  EXPECT_EQ(sharp->observed_diameter_m(45e-6), 45e-6);
  EXPECT_NEAR(sharp->observed_diameter_m(90e-6), 60e-6, kRounding * 60e-6);
  EXPECT_TRUE(e->of_measurement());
  EXPECT_EQ(e->adhesion_factor(kRadius), 1.0);
}

void check_adhesion_scatter() {
  const auto e = make_effect("adhesion_scatter", {0.4});
  EXPECT_EQ(e->adhesion_log_std(), 0.4);
  EXPECT_TRUE(e->of_measurement());
  EXPECT_EQ(e->observed_diameter_m(45e-6), 45e-6) << "the 50 % point is that of the median grain";
}

const std::map<std::string, std::function<void()>>& analytic_checks() {
  static const std::map<std::string, std::function<void()>> checks = {
      {"finite_stop_pulse", check_finite_stop_pulse},
      {"rate_dependent_adhesion", check_rate_dependent_adhesion},
      {"electrostatic_image_force", check_electrostatic_image_force},
      {"capillary_bridge", check_capillary_bridge},
      {"surface_roughness", check_surface_roughness},
      {"plastic_contact", check_plastic_contact},
      {"psd_cutoff", check_psd_cutoff},
      {"adhesion_scatter", check_adhesion_scatter},
  };
  return checks;
}

TEST(EffectRegistry, EveryEffectHasAnAnalyticCheckAndPassesIt) {
  std::set<std::string> registered;
  for (const EffectEntry& entry : effect_registry()) {
    const std::string& name = entry.info->name;
    SCOPED_TRACE(name);
    EXPECT_TRUE(registered.insert(name).second) << "is there twice";
    const auto check = analytic_checks().find(name);
    if (check == analytic_checks().end()) {
      ADD_FAILURE()
          << "no check against a closed form; write one in tests/physics/effects_test.cpp";
    } else {
      check->second();
    }
  }
  for (const auto& [name, check] : analytic_checks()) {
    EXPECT_EQ(registered.count(name), 1U)
        << "a check for '" << name << "', which is not in effects.def";
  }
}

bool ends_with_unit(const std::string& name) {
  for (const std::string& unit :
       std::vector<std::string>{"_s", "_m", "_um", "_Pa", "_m2", "_over_R"}) {
    if (name.size() > unit.size() &&
        name.compare(name.size() - unit.size(), unit.size(), unit) == 0) {
      return true;
    }
  }
  return false;
}

TEST(EffectRegistry, InfosAreComplete) {
  const std::set<std::string> dimensionless = {"plate_restitution", "exponent", "log_std",
                                               "cut_sharpness"};
  for (const EffectEntry& entry : effect_registry()) {
    SCOPED_TRACE(entry.info->name);
    EXPECT_EQ(entry.info->name.find_first_not_of("abcdefghijklmnopqrstuvwxyz0123456789_"),
              std::string::npos);
    EXPECT_FALSE(entry.info->mechanism.empty());
    EXPECT_FALSE(entry.info->signature.empty());
    EXPECT_FALSE(entry.info->decisive_test.empty());
    EXPECT_FALSE(entry.info->parameters.empty());
    EXPECT_LE(entry.info->parameters.size(), 2U);
    std::set<std::string> names;
    for (const EffectParameter& p : entry.info->parameters) {
      SCOPED_TRACE(p.name);
      EXPECT_TRUE(names.insert(p.name).second) << "is there twice";
      EXPECT_TRUE(dimensionless.count(p.name) == 1 || ends_with_unit(p.name)) << "no unit";
      EXPECT_FALSE(p.source.empty());
      EXPECT_LT(p.lower, p.upper);
      EXPECT_TRUE(std::isfinite(p.lower) && std::isfinite(p.upper));
      EXPECT_LE(p.lower, p.typical);
      EXPECT_LE(p.typical, p.upper);
      EXPECT_LT(p.plausible_lower, p.plausible_upper);
      EXPECT_LE(p.plausible_upper, p.upper);
    }
  }
}

std::vector<double> off_values(const EffectEntry& entry) {
  std::vector<double> off;
  for (const EffectParameter& p : entry.info->parameters) off.push_back(p.off);
  return off;
}

std::vector<double> typical_values(const EffectEntry& entry) {
  std::vector<double> typical;
  for (const EffectParameter& p : entry.info->parameters) typical.push_back(p.typical);
  return typical;
}

void expect_baseline(const Effect& e) {
  for (const double radius : {1e-6, 1e-4}) {
    EXPECT_EQ(e.adhesion_factor(radius), 1.0);
    EXPECT_EQ(e.range_m(radius), 0.0);
    for (const double gap : {-1e-8, 0.0, 1e-9, 1e-6}) {
      EXPECT_EQ(e.gap_force_N(gap, radius), 0.0) << gap;
      EXPECT_EQ(e.gap_energy_J(gap, radius), 0.0) << gap;
    }
  }
  const physics::JkrLaw law(1e10, 10.0);
  EXPECT_EQ(e.flattening_factor(law, kRadius), 1.0);
  EXPECT_EQ(e.observed_diameter_m(5e-5), 5e-5);
  EXPECT_EQ(e.adhesion_log_std(), 0.0);
  EXPECT_FALSE(e.rate_dependent());
  for (const double speed : {0.0, 1.0, 1e3}) EXPECT_EQ(e.fracture_energy_factor(speed), 1.0);
  if (const auto stop = e.stop()) {
    EXPECT_EQ(stop->kick_m_s(2.0), 2.0);
    EXPECT_EQ(stop->duration_s(), 0.0);
  }
}

/// The registry with one more effect, that makes nothing.
std::vector<EffectEntry> with_one_more(const physics::EffectInfo& info) {
  std::vector<EffectEntry> entries = effect_registry();
  entries.push_back({&info, {}});
  return entries;
}

TEST(EffectRegistry, NamesThatAreTakenAreRefused) {
  const physics::EffectInfo fine{"films", "", "", {{"film_exponent", 0, 1, 0, 1, 0, 1, ""}}};
  EXPECT_EQ(physics::require_distinct_names(with_one_more(fine)).size(),
            effect_registry().size() + 1);
  const physics::EffectInfo parameter{"films", "", "", {{"exponent", 0, 1, 0, 1, 0, 1, ""}}};
  const physics::EffectInfo energy{
      "films", "", "", {{"adhesive_energy_J_m2", 0, 1, 0, 1, 0, 1, ""}}};
  const physics::EffectInfo effect{"psd_cutoff", "", "", {}};
  EXPECT_TRUE(refuses([&] { physics::require_distinct_names(with_one_more(parameter)); },
                      "effect films", "'exponent', which rate_dependent_adhesion has"));
  EXPECT_TRUE(refuses([&] { physics::require_distinct_names(with_one_more(energy)); },
                      "effect films", "which the interface has"));
  EXPECT_TRUE(refuses([&] { physics::require_distinct_names(with_one_more(effect)); },
                      "effect psd_cutoff", "'psd_cutoff', which psd_cutoff has"));
}

TEST(EffectRegistry, OffValuesRecoverTheBaseline) {
  for (const EffectEntry& entry : effect_registry()) {
    SCOPED_TRACE(entry.info->name);
    expect_baseline(*entry.make(off_values(entry)));
  }
}

TEST(EffectRegistry, EitherParameterOfABridgeSwitchesItOff) {
  for (const std::vector<double>& off : {std::vector<double>{0.07, 0.0}, {0.0, 0.05}}) {
    const auto e = make_effect("capillary_bridge", off);
    for (const double gap : {-1e-8, 0.0, 1e-9}) {
      EXPECT_EQ(e->gap_force_N(gap, kRadius), 0.0) << gap;
      EXPECT_EQ(e->gap_energy_J(gap, kRadius), 0.0) << gap;
    }
  }
}

TEST(EffectRegistry, TypicalValuesAreTheDefault) {
  for (const EffectEntry& entry : effect_registry()) {
    const auto by_default = make_effect(entry.info->name, {});
    const auto given = make_effect(entry.info->name, typical_values(entry));
    EXPECT_EQ(by_default->adhesion_factor(kRadius), given->adhesion_factor(kRadius));
    EXPECT_EQ(by_default->gap_force_N(1e-7, kRadius), given->gap_force_N(1e-7, kRadius));
    EXPECT_EQ(by_default->fracture_energy_factor(0.3), given->fracture_energy_factor(0.3));
    EXPECT_EQ(by_default->stop().has_value(), given->stop().has_value());
  }
}

TEST(EffectRegistry, RefusesUnknownNamesAndWrongNumbersOfParameters) {
  EXPECT_TRUE(refuses([] { physics::find_effect("static_cling"); }, "effect", "static_cling"));
  try {
    physics::find_effect("static_cling");
  } catch (const InvalidInput& e) {
    for (const EffectEntry& entry : effect_registry()) {
      EXPECT_NE(std::string(e.what()).find(entry.info->name), std::string::npos)
          << "must list every name";
    }
  }
  for (const EffectEntry& entry : effect_registry()) {
    const std::string name = entry.info->name;
    const std::vector<double> too_many(entry.info->parameters.size() + 1, 1.0);
    EXPECT_TRUE(refuses([&] { make_effect(name, too_many); },
                        "effect " + name + ": number of parameters",
                        std::to_string(too_many.size())));
    if (entry.info->parameters.size() > 1) {
      EXPECT_TRUE(refuses([&] { make_effect(name, {1.0}); },
                          "effect " + name + ": number of parameters", "1"));
    }
  }
}

TEST(EffectRegistry, RefusesValuesOutOfRange) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const EffectEntry& entry : effect_registry()) {
    const auto& parameters = entry.info->parameters;
    for (std::size_t i = 0; i < parameters.size(); ++i) {
      for (const double bad : {-1.0, 1.01 * parameters[i].upper, nan}) {
        std::vector<double> values = typical_values(entry);
        values[i] = bad;
        EXPECT_TRUE(refuses([&] { make_effect(entry.info->name, values); },
                            "effect " + entry.info->name + ": " + parameters[i].name))
            << bad;
      }
    }
  }
  EXPECT_TRUE(refuses([] { make_effect("electrostatic_image_force", {1e-10}); },
                      "surface_charge_C_m2", "1e-10"))
      << "small values must be readable";
}

}  // namespace
}  // namespace powderlink
