// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/render/residual_table.h"

#include <algorithm>
#include <sstream>

#include "base/invalid_input.h"

namespace powderlink::render {

std::string residual_table(const RunResults& results, const std::string& source) {
  if (results.particles.empty() || !results.impact_velocity_m_s) {
    throw InvalidInput("residual velocities of " + source,
                       "kat_results.json without particles or impact_velocity_m_s, or no such file",
                       "the results of one drop test", "give the folder of one run");
  }
  auto particles = results.particles;
  std::sort(particles.begin(), particles.end(),
            [](const auto& a, const auto& b) { return a.diameter_m < b.diameter_m; });
  std::ostringstream table;
  table.precision(9);
  table << "# impact_velocity_m_s " << *results.impact_velocity_m_s << '\n';
  if (results.critical_diameter_m) {
    table << "# critical_diameter_um " << 1e6 * *results.critical_diameter_m << '\n';
  }
  table << "diameter_um,attached,speed_m_s\n";
  for (const ParticleResult& particle : particles) {
    table << 1e6 * particle.diameter_m << ',' << (particle.attached ? 1 : 0) << ','
          << particle.speed_m_s << '\n';
  }
  return table.str();
}

}  // namespace powderlink::render
