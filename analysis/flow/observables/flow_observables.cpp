// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/flow/observables/flow_observables.h"

namespace powderlink::analysis {

FlowObservables make_flow_observables(const FlowWindow& window, const FlowChannelShape& shape) {
  FlowObservables all;
  for (const auto make : {make_outlet_flow, make_inlet_pressure, make_section_profiles,
                          make_envelope, make_clusters, make_flow_front, make_force_balance}) {
    all.push_back(make(window, shape));
  }
  return all;
}

}  // namespace powderlink::analysis
