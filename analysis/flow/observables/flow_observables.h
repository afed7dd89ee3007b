// SPDX-License-Identifier: GPL-3.0-or-later
/// \file flow_observables.h
/// The observables that are registered, each made by its own file.
/// Tests: tests/analysis/flow/flow_observables_test.cpp
#pragma once

#include "analysis/flow/observables/flow_observable.h"

namespace powderlink::analysis {

/// outlet_flow.cpp
std::unique_ptr<FlowObservable> make_outlet_flow(const FlowWindow&, const FlowChannelShape&);
/// inlet_pressure.cpp
std::unique_ptr<FlowObservable> make_inlet_pressure(const FlowWindow&, const FlowChannelShape&);
/// section_profiles.cpp
std::unique_ptr<FlowObservable> make_section_profiles(const FlowWindow&, const FlowChannelShape&);
/// envelope.cpp
std::unique_ptr<FlowObservable> make_envelope(const FlowWindow&, const FlowChannelShape&);
/// clusters.cpp
std::unique_ptr<FlowObservable> make_clusters(const FlowWindow&, const FlowChannelShape&);
/// flow_front.cpp
std::unique_ptr<FlowObservable> make_flow_front(const FlowWindow&, const FlowChannelShape&);
/// force_balance.cpp
std::unique_ptr<FlowObservable> make_force_balance(const FlowWindow&, const FlowChannelShape&);

}  // namespace powderlink::analysis
