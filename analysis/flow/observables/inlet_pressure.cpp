// SPDX-License-Identifier: GPL-3.0-or-later
/// Pressure at the inlet over time, and its elbow: where it stops to rise as the channel fills
/// (elbow.h). The whole record counts, not only the established part. The elbow is that of medians
/// over half a window of averages: grains that appear all at once displace gas, which answers with a
/// stroke of pressure that is no flow.
///   p = rho <p_kin>_inlet, of the function object inletPressure (surfaceFieldValue, areaAverage)
#include <fmt/format.h>

#include <boost/math/statistics/univariate_statistics.hpp>
#include <cmath>

#include "analysis/flow/observables/elbow.h"
#include "analysis/flow/observables/flow_observables.h"
#include "analysis/flow/run/run_tables.h"

namespace powderlink::analysis {

namespace {

constexpr double kBlock = 0.5;  // of the window of averages

/// Medians of blocks of rows, at the means of their times.
void median_blocks(const std::vector<double>& times, const std::vector<double>& values,
                   double block, std::vector<double>& block_times,
                   std::vector<double>& block_values) {
  std::vector<double> own;
  double sum = 0.0;
  const auto number = [&](double time) { return std::floor((time - times.front()) / block); };
  for (std::size_t i = 0; i < times.size(); ++i) {
    own.push_back(values[i]);
    sum += times[i];
    if (i + 1 < times.size() && number(times[i + 1]) == number(times[i])) continue;
    block_times.push_back(sum / static_cast<double>(own.size()));
    block_values.push_back(boost::math::statistics::median(own));
    own.clear();
    sum = 0.0;
  }
}

class InletPressure : public FlowObservable {
 public:
  FlowFindings find(const FlowScene& scene) override {
    FlowFindings found;
    const RunTable table = read_function_object(scene.folder, "inletPressure", "surfaceFieldValue");
    if (table.rows.empty() || !scene.gas_density_kg_m3) {
      found.notes.push_back(
          table.rows.empty()
              ? "no pressure at the inlet: postProcessing/ has no inletPressure; "
                "add a function object surfaceFieldValue of that name, as in foam_cases/pipe"
              : "no pressure at the inlet in Pa: give --density kg/m^3");
      return found;
    }
    std::vector<double> times_s, pressure_Pa;
    for (const auto& [time_s, values] : table.rows) {
      times_s.push_back(time_s);
      pressure_Pa.push_back(*scene.gas_density_kg_m3 * values.front());
    }
    const auto mean = table.mean(0, scene.window().from_s, times_s.back());
    found.numbers.push_back(
        {"inlet_pressure_Pa",
         mean ? std::optional(*mean * *scene.gas_density_kg_m3) : std::nullopt});
    std::vector<double> block_s, block_Pa;
    median_blocks(times_s, pressure_Pa, kBlock * scene.measures.average_s, block_s, block_Pa);
    const auto elbow = find_elbow(block_s, block_Pa);
    if (elbow) {
      found.numbers.push_back({"inlet_pressure_elbow_s", elbow->time, elbow->interval});
      found.numbers.push_back({"inlet_pressure_slope_before_Pa_s", elbow->slope_before});
      found.numbers.push_back({"inlet_pressure_slope_after_Pa_s", elbow->slope_after});
      found.text = fmt::format(
          "inlet pressure bends at {:.4g} s ({:.4g} to {:.4g}): {:.4g} Pa/s before, {:.4g} after\n",
          elbow->time, elbow->interval.from, elbow->interval.to, elbow->slope_before,
          elbow->slope_after);
    } else {
      found.numbers.push_back({"inlet_pressure_elbow_s", std::nullopt});
      found.notes.emplace_back(
          "no elbow in the pressure at the inlet: "
          "straight pieces that meet fit it no better than one line");
    }
    std::string text =
        elbow ? fmt::format(
                    "# straight pieces that meet, the elbow at {:.9g} s, "
                    "95 % {:.9g} to {:.9g} s, from {:.0f} independent rows\n",
                    elbow->time, elbow->interval.from, elbow->interval.to, elbow->independent_rows)
              : "";
    text += "time_s,pressure_Pa,fit_Pa\n";
    for (std::size_t i = 0; i < times_s.size(); ++i) {
      text += fmt::format("{:.9g},{:.9g},{}\n", times_s[i], pressure_Pa[i],
                          elbow ? fmt::format("{:.9g}", elbow->at(times_s[i])) : "");
    }
    found.tables.emplace_back("inlet_pressure.csv", text);
    found.figures.push_back(
        {"inlet_pressure",
         fmt::format("elbow_s={:.9g}; low_s={:.9g}; high_s={:.9g}", elbow ? elbow->time : -1.0,
                     elbow ? elbow->interval.from : 0.0, elbow ? elbow->interval.to : 0.0),
         times_s.size() < 2 ? "there is one row only" : ""});
    return found;
  }
};

}  // namespace

std::unique_ptr<FlowObservable> make_inlet_pressure(const FlowWindow& /*window*/,
                                                    const FlowChannelShape& /*shape*/) {
  return std::make_unique<InletPressure>();
}

}  // namespace powderlink::analysis
