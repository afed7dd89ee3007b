// SPDX-License-Identifier: GPL-3.0-or-later
/// Balance of the forces on gas and powder over a part of the channel, term by term, along the
/// flow: where the pressure goes. Means over the established states in N; divided by the area of the
/// section they are pressures.
///   gas     (p_1 - p_2) A = wall shear + force on the powder + rho d(int u^2 dA)
///   powder  force of the gas + force of the wall + weight = momentum out - momentum in + dP/dt
/// The part is between the two probes `balanceEnds`; there the surfaces balanceInflow and
/// balanceOutflow integrate u^2. Pressure: the probes along the axis, linear between them. Wall
/// shear: bins of the function object wallForce (forces, binData along the axis). Forces on the
/// grains: post/powder_forces_*.txt (fix ave/spatial), which sees short collisions too. Momentum of
/// the grains: momentum_account.h. A bin that reaches over an end counts with its part inside.
/// A gas of given flow rate keeps its momentum; what displaced gas changes of it is left out.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <sstream>

#include "analysis/flow/foam/foam_files.h"
#include "analysis/flow/observables/flow_observables.h"
#include "analysis/flow/observables/momentum_account.h"
#include "analysis/flow/run/run_tables.h"
#include "base/text/text_table.h"

namespace powderlink::analysis {

namespace {

constexpr double kLongestStep = 0.25;  // of the part, between two states

/// Share of [low, high] that lies in the part.
double share_inside(double low, double high, const Interval& part) {
  const double inside = std::min(high, part.to) - std::max(low, part.from);
  return std::clamp(inside / (high - low), 0.0, 1.0);
}

struct Term {
  const char* balance;
  const char* name;
  const char* key;
  double force_N;
};

class ForceBalance : public FlowObservable {
 public:
  explicit ForceBalance(const FlowWindow& window) : axis_(window.axis) {}

  void add(double time_s, const DumpState& state) override {
    if (account_) account_->add(time_s, state);
  }

  void begin(const std::filesystem::path& folder) override {
    const auto ends = probe_places(folder, "balanceEnds", "U");
    if (ends.size() != 2) return;
    part_m_ = {std::min(axis_.place_m(ends[0]), axis_.place_m(ends[1])),
               std::max(axis_.place_m(ends[0]), axis_.place_m(ends[1]))};
    if (part_m_.to > part_m_.from) account_.emplace(axis_, part_m_);
  }

  FlowFindings find(const FlowScene& scene) override {
    FlowFindings found;
    const auto lacks = [&](const std::string& what) {
      found.notes.push_back("no balance of forces: " + what +
                            "; foam_cases/pipe has what it takes, docs/flow.md names it");
      return found;
    };
    if (!account_) return lacks("postProcessing/balanceEnds has no two probes of U on the axis");
    if (account_->states() < 2) return lacks("fewer than two dumps from --from on");
    if (account_->longest_step() > kLongestStep) {
      return lacks(fmt::format("grains move {:.2g} times the part's length between two dumps",
                               account_->longest_step()));
    }
    if (!scene.gas_density_kg_m3 || scene.pressure == nullptr) return lacks("no pressure in Pa");
    const RunTable inflow =
        read_function_object(scene.folder, "balanceInflow", "surfaceFieldValue");
    const RunTable outflow =
        read_function_object(scene.folder, "balanceOutflow", "surfaceFieldValue");
    const RunTable wall = read_function_object(scene.folder, "wallForce", "forceBin");
    const auto area_m2 = inflow.head_number("Area");
    const double from_s = account_->first_s(), to_s = account_->last_s();
    const auto in = inflow.mean(0, from_s, to_s), out = outflow.mean(0, from_s, to_s);
    if (!area_m2 || !in || !out) return lacks("no balanceInflow and balanceOutflow in that time");
    const auto on_wall = wall_force_N(scene, wall, from_s, to_s);
    if (!on_wall) return lacks("no wallForce in bins along the axis in that time");
    const auto on_powder = powder_forces_N(scene, from_s, to_s);
    if (!on_powder) return lacks("no post/powder_forces_*.txt in that time");
    const auto high = pressure_at(scene, part_m_.from), low = pressure_at(scene, part_m_.to);
    if (!high || !low) return lacks("no probes of p on both ends of the part");

    const double way = axis_.way;
    const double duration_s = to_s - from_s;
    const double drop_N = way * (*high - *low) * *area_m2;
    const double flux_N = *scene.gas_density_kg_m3 * (*out - *in);
    const double fluid_N = way * on_powder->second, friction_N = way * on_powder->first;
    // In and out carry momentum m v, v downstream: either end counts alike.
    const double entered_N = account_->entered_kg_m_s() / duration_s;
    const double left_N = account_->left_kg_m_s() / duration_s;
    const double stored_N = (account_->last_kg_m_s() - account_->first_kg_m_s()) / duration_s;
    const double weight_N = way * account_->mean_mass_kg() * gravity_m_s2(scene.folder);
    const double gas_rest_N = drop_N - way * *on_wall - fluid_N - flux_N;
    const double powder_rest_N = fluid_N + friction_N + weight_N - (left_N - entered_N) - stored_N;
    const std::vector<Term> terms{
        {"gas", "pressure drop", "pressure_drop", drop_N},
        {"gas", "wall shear", "gas_wall", way * *on_wall},
        {"gas", "force on the powder", "gas_on_powder", fluid_N},
        {"gas", "change of its momentum flux", "gas_momentum", flux_N},
        {"gas", "not closed", "gas_rest", gas_rest_N},
        {"powder", "force of the gas", "powder_by_gas", fluid_N},
        {"powder", "friction at the wall", "powder_friction", friction_N},
        {"powder", "weight along the axis", "powder_weight", weight_N},
        {"powder", "change of its momentum flux", "powder_momentum", left_N - entered_N},
        {"powder", "momentum that it stores", "powder_stored", stored_N},
        {"powder", "not closed", "powder_rest", powder_rest_N}};
    write(found, terms, *area_m2, from_s, to_s);
    found.numbers.push_back(
        {"force_balance_gas_open_percent", 100.0 * std::abs(gas_rest_N / drop_N)});
    found.numbers.push_back(
        {"force_balance_powder_open_percent", 100.0 * std::abs(powder_rest_N / fluid_N)});
    return found;
  }

 private:
  /// Linear between the probes; empty beyond them.
  static std::optional<double> pressure_at(const FlowScene& scene, double place_m) {
    const auto& probes = scene.pressure->probes;
    const double hair_m = 1e-9;  // digits of a probe's place
    for (std::size_t i = 1; i < probes.size(); ++i) {
      const ProbeMean &a = probes[i - 1], &b = probes[i];
      if (place_m < a.place_m - hair_m || place_m > b.place_m + hair_m) continue;
      if (!(b.place_m > a.place_m)) continue;
      return a.pressure_Pa +
             (place_m - a.place_m) / (b.place_m - a.place_m) * (b.pressure_Pa - a.pressure_Pa);
    }
    return {};
  }

  /// Of the gas on the wall, along the axis. The bins part the faces' centres, so whole layers of
  /// cells; the channel's own ends are the bins' ends.
  std::optional<double> wall_force_N(const FlowScene& scene, const RunTable& table, double from_s,
                                     double to_s) const {
    const auto bins = table.head_number("bins"), start = table.head_number("start"),
               end = table.head_number("end");
    if (!bins || !start || !end || table.rows.empty()) return {};
    const auto count = static_cast<std::size_t>(*bins);
    constexpr std::size_t kValues = 9;  // total, pressure, viscous
    const std::size_t per_bin = table.rows.begin()->second.size() / std::max<std::size_t>(count, 1);
    if (per_bin < kValues) return {};
    const double first = scene.mesh_m ? scene.mesh_m->from : *start;
    const double last = scene.mesh_m ? scene.mesh_m->to : *end;
    const double width = (last - first) / *bins;
    double force = 0.0;
    for (std::size_t i = 0; i < count; ++i) {
      const double left = first + width * static_cast<double>(i);
      const double share = share_inside(left, left + width, part_m_);
      if (share == 0.0) continue;
      const auto mean = table.mean(i * per_bin + axis_.index, from_s, to_s);
      if (!mean) return {};
      force += share * *mean;
    }
    return force;
  }

  /// Of wall and gas on the grains, along the axis.
  std::optional<std::pair<double, double>> powder_forces_N(const FlowScene& scene, double from_s,
                                                           double to_s) const {
    double wall = 0.0, fluid = 0.0;
    std::size_t count = 0;
    for (const BinnedForces& state : read_powder_forces(scene.folder)) {
      const double time_s = scene.clock->gas_time_s(state.step);
      if (!(time_s > from_s && time_s <= to_s) || state.centre_m.size() < 2) continue;
      ++count;
      const double half = 0.5 * (state.centre_m[1] - state.centre_m[0]);
      for (std::size_t i = 0; i < state.centre_m.size(); ++i) {
        const double share =
            share_inside(state.centre_m[i] - half, state.centre_m[i] + half, part_m_);
        wall += share * state.wall_N[i];
        fluid += share * state.fluid_N[i];
      }
    }
    if (count == 0) return {};
    return std::pair(wall / static_cast<double>(count), fluid / static_cast<double>(count));
  }

  double gravity_m_s2(const std::filesystem::path& folder) const {
    const std::filesystem::path file = std::filesystem::path("constant") / "g";
    if (!foam_file_exists(folder / file)) return 0.0;
    const auto value = read_foam_entry(folder, {file, "value"});
    if (!value) return 0.0;
    std::string text = value->text;
    text = text.substr(std::min(text.find('(') + 1, text.size()));
    std::istringstream numbers(text);
    Place g{};
    if (!(numbers >> g[0] >> g[1] >> g[2])) return 0.0;
    return g.at(axis_.index);
  }

  void write(FlowFindings& found, const std::vector<Term>& terms, double area_m2, double from_s,
             double to_s) const {
    std::string csv = fmt::format(
        "# {0} = {1:g} to {2:g} m, {3:g} to {4:g} s, area {5:.9g} m^2\n"
        "# gas: pressure drop = the other terms; "
        "powder: gas + friction + weight = the other terms\n"
        "balance,term,force_N,pressure_Pa,share_percent\n",
        axis_.letter(), part_m_.from, part_m_.to, from_s, to_s, area_m2);
    TextTable table(
        {fmt::format("forces, {} = {:g} to {:g} m", axis_.letter(), part_m_.from, part_m_.to),
         "term", "Pa", "% of the drop"});
    table.flush_left(1);
    const double drop_N = terms.front().force_N;
    for (const Term& term : terms) {
      const double share = 100.0 * term.force_N / drop_N;
      csv += fmt::format("{},{},{:.9g},{:.6g},{:.4g}\n", term.balance, term.name, term.force_N,
                         term.force_N / area_m2, share);
      table.add({term.balance, term.name, fmt::format("{:.5g}", term.force_N / area_m2),
                 fmt::format("{:.2f}", share)});
      found.numbers.push_back({fmt::format("force_balance_{}_N", term.key), term.force_N});
    }
    found.tables.emplace_back("force_balance.csv", csv);
    found.figures.push_back({"force_balance", "", ""});
    found.text = table.text();
  }

  FlowAxis axis_;
  Interval part_m_;
  std::optional<MomentumAccount> account_;
};

}  // namespace

std::unique_ptr<FlowObservable> make_force_balance(const FlowWindow& window,
                                                   const FlowChannelShape& /*shape*/) {
  return std::make_unique<ForceBalance>(window);
}

}  // namespace powderlink::analysis
