// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/kat/dem/drop_script.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "physics/contact/rayleigh_time.h"
#include "physics/effects/adhesive_contact.h"
#include "physics/effects/effect_registry.h"
#include "physics/kat/kat_theory.h"

namespace powderlink::analysis {

using physics::StopPulse;

namespace {

constexpr double kGridSpacing = 1.2;  // of fix kat/drop, in largest diameters
constexpr double kBoxMargin = 1.1;    // around that grid
constexpr double kDepth = 10.0;       // below the plate, in largest diameters, before any flight
constexpr double kFlightReserve = 1.5;
constexpr double kWatchPeriods = 6.0;  // fix kat/drop's own default after the stop
constexpr double kSkin = 0.5;          // smallest diameters
constexpr double kTearOffGaps = 4.0;   // the skin must hold a neck,
constexpr double kTearOffGapsRate =
    40.0;                      // and that of a rate-dependent edge is up to 25 times longer
constexpr int kPictures = 40;  // states per run

/// What the drop means in numbers that the script needs.
struct Layout {
  StopPulse stop;
  double time_step_s, half_width_m, depth_m, top_m, skin_m;
  long dump_every;
};

Layout layout(const DropScript& d) {
  Layout l;
  const double radius = 0.5 * d.largest_diameter_m;
  const physics::JkrLaw law(physics::effective_youngs_modulus_Pa(d.particle, d.substrate),
                            d.work_of_adhesion_J_m2);
  double range = 0.0;
  double tear_off_gaps = kTearOffGaps;
  double tear_off_m = -law.tear_off_overlap_m(radius);
  for (const EffectChoice& choice : d.effects) {
    const auto effect = physics::make_effect(choice.name, choice.parameters);
    for (const double at : {0.5 * d.smallest_diameter_m, radius}) {
      const physics::AdhesiveContact contact(law, {effect.get()});
      tear_off_m = std::max(tear_off_m, -contact.law(at).tear_off_overlap_m(at));
    }
    if (const auto stop = effect->stop()) l.stop = *stop;
    if (effect->rate_dependent()) tear_off_gaps = kTearOffGapsRate;
    if (std::isfinite(effect->range_m(radius))) range = std::max(range, effect->range_m(radius));
  }
  l.time_step_s = d.options.time_step_rayleigh *
                  physics::rayleigh_time_s(0.5 * d.smallest_diameter_m, d.particle);
  const double period = 2.0 * physics::JkrLaw::kPi *
                        std::sqrt(physics::sphere_mass_kg(radius, d.particle.density_kg_m3) /
                                  law.equilibrium_stiffness_N_m(radius));
  const double duration = l.stop.duration_s() + kWatchPeriods * period;
  const double side = std::ceil(std::sqrt(static_cast<double>(d.options.particles)));
  l.half_width_m = 0.5 * side * kGridSpacing * d.largest_diameter_m * kBoxMargin;
  l.depth_m = kDepth * d.largest_diameter_m +
              kFlightReserve * l.stop.speed_change_m_s(d.impact_velocity_m_s) * duration;
  l.top_m = 2.0 * d.largest_diameter_m;
  if (d.options.moving_frame) {  // a rebounding plate comes back and goes on upwards
    l.top_m += kFlightReserve * l.stop.rebound() * d.impact_velocity_m_s * duration;
  }
  l.skin_m = std::max({kSkin * d.smallest_diameter_m, tear_off_gaps * tear_off_m, 2.0 * range});
  l.dump_every = std::max(1L, std::lround(duration / l.time_step_s / kPictures));
  return l;
}

std::string stop_keyword(const StopPulse& stop) {
  std::string text = "stop instant";
  if (stop.shape() == StopPulse::Shape::half_sine)
    text = fmt::format("stop halfsine {:.9g}", stop.duration_s());
  if (stop.shape() == StopPulse::Shape::hertz)
    text = fmt::format("stop hertz {:.9g}", stop.duration_s());
  return stop.rebound() > 0.0 ? text + fmt::format(" rebound {:.9g}", stop.rebound()) : text;
}

/// The stop is the keyword's business, what belongs to the measurement acts on no grain; all other
/// effects are fixes of their own.
std::string effect_fixes(const std::vector<EffectChoice>& effects) {
  std::string text;
  int number = 0;
  for (const EffectChoice& choice : effects) {
    const auto effect = physics::make_effect(choice.name, choice.parameters);
    if (effect->stop() || effect->of_measurement()) continue;
    text += fmt::format("fix             eff{} all adhesion/effect {}", ++number, choice.name);
    for (const double value : choice.parameters) text += fmt::format(" {:.9g}", value);
    text += "\n";
  }
  return text.empty() ? "" : "\n# beyond JKR (powderlink effects)\n" + text;
}

void validate(const DropScript& d) {
  if (!(d.smallest_diameter_m > 0.0 && d.largest_diameter_m > d.smallest_diameter_m)) {
    throw InvalidInput(
        "sizes of the drop",
        fmt::format("{:g} to {:g} um", d.smallest_diameter_m * 1e6, d.largest_diameter_m * 1e6),
        "0 < smallest < largest", "correct diameter_range_um");
  }
}

}  // namespace

std::string drop_script(const DropScript& d) {
  validate(d);
  const Layout l = layout(d);
  const std::string wall =
      d.options.mesh_wall
          ? fmt::format(
                "fix             cad all mesh/surface file {} type 2 precision 1e-12\n"
                "fix             plate all wall/gran model jkr tangential off mesh n_meshes 1 "
                "meshes cad",
                kPlateFile)
          : "fix             plate all wall/gran model jkr tangential off primitive type 2 zplane "
            "0.0";
  const std::string plate_dump =
      d.options.mesh_wall
          ? fmt::format("dump            plt all mesh/vtk {} post/plate_*.vtk id cad\n",
                        l.dump_every)
          : "";
  return fmt::format(
      R"(# {title}
# Kinetic Adhesion Test: {n} particles, {dmin_um:.6g} to {dmax_um:.6g} um, hang under a plate that falls
# with them in front and is stopped at {v:g} m/s. What is larger than the critical diameter leaves.
# Run by hand:  liggghts-powderlink -in {script}

units           si
atom_style      granular
atom_modify     map array
boundary        f f f
newton          off
communicate     single vel yes
hard_particles  yes

# particles are type 1, the plate is type 2
region          box block -{w:.9g} {w:.9g} -{w:.9g} {w:.9g} -{depth:.9g} {top:.9g} units box
create_box      2 box
neighbor        {skin:.9g} bin
neigh_modify    delay 0

# material: {particle} on {substrate}
fix             m1 all property/global youngsModulus peratomtype {E1:.9g} {E2:.9g}
fix             m2 all property/global poissonsRatio peratomtype {nu1:.9g} {nu2:.9g}
fix             m3 all property/global coefficientRestitution peratomtypepair 2 {e:.9g} {e:.9g} {e:.9g} {e:.9g}
# work of adhesion of the interface [J/m^2]; pull-off is 1.5 pi Gamma R
fix             m4 all property/global workOfAdhesion peratomtypepair 2 0 {gamma:.9g} {gamma:.9g} 0
pair_style      gran model jkr tangential off
pair_coeff      * *

# {rayleigh:g} Rayleigh times of the smallest particle
timestep        {dt:.9g}
fix             integr all nve/sphere
{wall}
{effects}
fix             kat all kat/drop wall plate plate zplane 0.0 fall -z velocity {v:.9g} &
                {stop} frame {frame} &
                populate type 1 density {rho:.9g} sizes range {dmin:.12g} {dmax:.12g} {n} &
                results {results}

# f_kat per particle: attached (2: by a force across the gap), speed away from the plate, contact
# radius, kinetic, stored and dissipated energy, work of inertia, gravity and gap forces, residual of
# the energy over the impact energy and of the momentum over the impact momentum
shell           mkdir post
dump            dmp all custom/vtk {every} post/particles_*.vtp id type radius x y z vx vy vz fx fy fz f_kat[1] f_kat[2] f_kat[3]
{plate_dump}thermo_style    custom step atoms f_kat[5] f_kat[6] f_kat[2]
thermo          {every}
kat/run         kat
)",
      fmt::arg("title", d.title), fmt::arg("n", d.options.particles),
      fmt::arg("dmin_um", d.smallest_diameter_m * 1e6),
      fmt::arg("dmax_um", d.largest_diameter_m * 1e6), fmt::arg("v", d.impact_velocity_m_s),
      fmt::arg("script", kScriptFile), fmt::arg("w", l.half_width_m), fmt::arg("depth", l.depth_m),
      fmt::arg("top", l.top_m), fmt::arg("skin", l.skin_m), fmt::arg("particle", d.particle.name),
      fmt::arg("substrate", d.substrate.name), fmt::arg("E1", d.particle.youngs_modulus_Pa),
      fmt::arg("E2", d.substrate.youngs_modulus_Pa), fmt::arg("nu1", d.particle.poissons_ratio),
      fmt::arg("nu2", d.substrate.poissons_ratio), fmt::arg("e", d.options.restitution),
      fmt::arg("gamma", d.work_of_adhesion_J_m2),
      fmt::arg("rayleigh", d.options.time_step_rayleigh), fmt::arg("dt", l.time_step_s),
      fmt::arg("wall", wall), fmt::arg("effects", effect_fixes(d.effects)),
      fmt::arg("stop", stop_keyword(l.stop)),
      fmt::arg("frame", d.options.moving_frame ? "moving" : "plate"),
      fmt::arg("rho", d.particle.density_kg_m3), fmt::arg("dmin", d.smallest_diameter_m),
      fmt::arg("dmax", d.largest_diameter_m), fmt::arg("results", kResultsFile),
      fmt::arg("every", l.dump_every), fmt::arg("plate_dump", plate_dump));
}

std::string plate_stl(const DropScript& d) {
  validate(d);
  const double w = layout(d).half_width_m;
  const auto triangle = [](double x1, double y1, double x2, double y2, double x3, double y3) {
    return fmt::format(
        "facet normal 0 0 -1\n outer loop\n  vertex {:.9g} {:.9g} 0\n  vertex {:.9g} {:.9g} 0\n"
        "  vertex {:.9g} {:.9g} 0\n endloop\nendfacet\n",
        x1, y1, x2, y2, x3, y3);
  };
  return "solid plate\n" + triangle(-w, -w, w, w, w, -w) + triangle(-w, -w, -w, w, w, w) +
         "endsolid plate\n";
}

}  // namespace powderlink::analysis
