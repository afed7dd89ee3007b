// SPDX-License-Identifier: GPL-3.0-or-later
// One critical diameter with the reduced model, for every kind of stop and effect. Target: 5 ms.
#include <benchmark/benchmark.h>

#include "analysis/kat/reduced/critical_diameter.h"
#include "analysis/kat/study/material_library.h"
#include "physics/effects/effect_registry.h"

namespace {

using powderlink::analysis::KatSetup;
using powderlink::physics::StopPulse;

void find(benchmark::State& state, const KatSetup& setup, double velocity_m_s) {
  const powderlink::analysis::ReducedModel model(setup);
  double diameter_um = 0.0;
  for (auto _ : state) {
    diameter_um = powderlink::analysis::critical_diameter(model, velocity_m_s).diameter_m * 1e6;
    benchmark::DoNotOptimize(diameter_um);
  }
  state.counters["d_c_um"] = diameter_um;
}

KatSetup drop(const std::string& particle, const std::string& substrate, double energy) {
  KatSetup s;
  s.particle = powderlink::analysis::find_material(particle);
  s.substrate = powderlink::analysis::find_material(substrate);
  s.work_of_adhesion_J_m2 = energy;
  return s;
}

void instant_stop(benchmark::State& state) { find(state, drop("316L", "UPVC", 17.175), 1.4); }
BENCHMARK(instant_stop)->Unit(benchmark::kMillisecond);

/// Arguments: duration [us], velocity [0.1 m/s].
void half_sine_stop(benchmark::State& state) {
  KatSetup s = drop("borosilicate_glass", "borosilicate_glass", 0.09);
  s.stop = StopPulse::half_sine(static_cast<double>(state.range(0)) * 1e-6);
  find(state, s, 0.1 * static_cast<double>(state.range(1)));
}
BENCHMARK(half_sine_stop)
    ->ArgNames({"tau_us", "v_dm_s"})
    ->Args({10, 30})
    ->Args({100, 18})
    ->Args({100, 60})
    ->Args({200, 60})
    ->Unit(benchmark::kMillisecond);

void effect(benchmark::State& state, const char* name, double energy, double velocity) {
  KatSetup s = drop("borosilicate_glass", "borosilicate_glass", energy);
  s.effects = {powderlink::physics::make_effect(name, {})};
  find(state, s, velocity);
}
BENCHMARK_CAPTURE(effect, rate_dependent_adhesion, "rate_dependent_adhesion", 10.0, 2.0)
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(effect, electrostatic_image_force, "electrostatic_image_force", 40.0, 3.0)
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(effect, capillary_bridge, "capillary_bridge", 0.001, 0.3)
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(effect, surface_roughness, "surface_roughness", 50.0, 2.0)
    ->Unit(benchmark::kMillisecond);

}  // namespace
