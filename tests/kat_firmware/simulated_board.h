// SPDX-License-Identifier: GPL-3.0-or-later
/// \file simulated_board.h
/// A board in a world with gravity: what the magnet lets go falls through the beam onto the anvil and
/// bounces. Edges reach the machine as interrupts do, at their own time, between two turns of the
/// loop. Times are rounded down to the microsecond, as a clock does.
#pragma once

#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

#include "kat_firmware/core/kat_machine.h"

namespace kat {

constexpr double kGravity_m_s2 = 9.80665;

struct Scene {
  double height_m = 0.2;           ///< that the lower edge of the carrier falls
  double carrier_m = 0.01;         ///< what blocks the beam
  double beam_m = 0.03;            ///< above the anvil
  double release_delay_s = 0.004;  ///< of the magnet
  double contact_s = 100e-6;
  double restitution = 0.3;  ///< of carrier and anvil
  int bounces = 3;           ///< then it rests, contact closed
  double latency_s = 66e-6;  ///< of the vibration switch
  double impact_velocity_m_s() const { return std::sqrt(2.0 * kGravity_m_s2 * height_m); }
};

class SimulatedBoard : public Board {
 public:
  using Edges = std::vector<Edge>;

  Scene scene;
  std::function<void(Edges&)> disturb = [](Edges&) {};  ///< changes what the machine gets to see
  std::function<void(uint32_t)> on_clock = [](uint32_t) {};  ///< called when the machine reads it
  uint32_t clock_at_start = 0;
  uint32_t switches_mV = kNoValue, peak_mg = kNoValue;
  bool magnet = false, sensors = false, blocked = false, closed = false;

  uint32_t now_us() override {
    const uint32_t t = static_cast<uint32_t>(clock_at_start + time_us_);
    on_clock(t);
    return t;
  }
  void set_magnet(bool on) override {
    if (magnet && !on && sensors) let_go();
    magnet = on;
  }
  void set_sensors(bool on) override { sensors = on; }
  bool beam_blocked() override { return blocked; }
  bool contact_closed() override { return closed; }
  uint32_t switch_mV() override { return switches_mV; }
  uint32_t acceleration_mg() override { return peak_mg; }

  /// Time goes on, with a turn of the loop every `step_us`.
  void run(
      Machine& machine, uint64_t duration_us, uint64_t step_us = 500,
      const std::function<void()>& turn = [] {}) {
    const uint64_t end = time_us_ + duration_us;
    while (time_us_ < end) {
      time_us_ = std::min(end, time_us_ + step_us);
      while (next_ < edges_.size() && due(edges_[next_])) interrupt(machine, edges_[next_++]);
      machine.poll();
      turn();
    }
  }
  /// True times of the last fall, since release.
  const Edges& true_edges() const { return true_edges_; }

 private:
  bool due(const Edge& edge) {
    const uint32_t now = static_cast<uint32_t>(clock_at_start + time_us_);
    return now - edge.time_us < 0x80000000U;
  }

  void interrupt(Machine& machine, const Edge& edge) {
    if (edge.kind == EdgeKind::beam_blocked || edge.kind == EdgeKind::beam_clear)
      blocked = edge.kind == EdgeKind::beam_blocked;
    if (edge.kind == EdgeKind::contact_closed || edge.kind == EdgeKind::contact_open)
      closed = edge.kind == EdgeKind::contact_closed;
    machine.edge(edge.kind, edge.time_us);
  }

  void let_go() {
    const auto fallen = [&](double distance_m) {
      return scene.release_delay_s + std::sqrt(2.0 * distance_m / kGravity_m_s2);
    };
    true_edges_.clear();
    const auto add = [&](EdgeKind kind, double t_s) {
      true_edges_.push_back({kind, static_cast<uint32_t>(t_s * 1e6)});
    };
    add(EdgeKind::beam_blocked, fallen(scene.height_m - scene.beam_m));
    add(EdgeKind::beam_clear, fallen(scene.height_m - scene.beam_m + scene.carrier_m));
    double t = fallen(scene.height_m);
    double v = scene.impact_velocity_m_s();
    add(EdgeKind::vibration, t + scene.latency_s);
    for (int i = 0; i < scene.bounces; ++i) {
      add(EdgeKind::contact_closed, t);
      add(EdgeKind::contact_open, t + scene.contact_s);
      v *= scene.restitution;
      t += scene.contact_s + 2.0 * v / kGravity_m_s2;
    }
    add(EdgeKind::contact_closed, t);
    edges_ = true_edges_;
    disturb(edges_);
    const uint32_t released = static_cast<uint32_t>(clock_at_start + time_us_);
    for (Edge& edge : edges_) edge.time_us += released;
    std::stable_sort(edges_.begin(), edges_.end(), [&](const Edge& a, const Edge& b) {
      return a.time_us - released < b.time_us - released;
    });
    next_ = 0;
  }

  uint64_t time_us_ = 0;
  Edges edges_, true_edges_;
  std::size_t next_ = 0;
};

}  // namespace kat
