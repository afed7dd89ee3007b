// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/sizes/pictures/psd_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "analysis/sizes/pictures/grain_source.h"
#include "analysis/sizes/table_doubts.h"
#include "base/invalid_input.h"

namespace powderlink::analysis {

namespace fs = std::filesystem;

namespace {

const std::vector<double> kShares = {0.1, 0.5, 0.9};
constexpr double kSpeckReach = 6.0;     // interquartile ranges of ln d by mass below the quartile
constexpr double kSpecksMass = 0.01;    // a second population has more
constexpr std::size_t kFewGrains = 30;  // fewer: percentile intervals are too narrow
constexpr double kSmallMedian_px = 10.0;

void flag_specks(PsdReport& report) {
  std::vector<double> d;
  for (const Particle& p : report.set.particles)
    d.push_back(diameter_um(p, report.options.diameter));
  const SizeDistribution mass(d, Weighting::mass);
  const double q1 = mass.quantile_um(0.25), q3 = mass.quantile_um(0.75);
  double fence = q1 * std::pow(q1 / q3, kSpeckReach), below = 0.0;
  for (std::size_t i = 0; i < d.size() && mass.diameters_um()[i] < fence; ++i)
    below += mass.weights()[i] / static_cast<double>(d.size());
  if (below > kSpecksMass) fence = 0.0;
  std::vector<Particle> kept;
  const double min = report.options.min_um, max = report.options.max_um;
  for (std::size_t i = 0; i < d.size(); ++i) {
    const bool speck = d[i] < fence;
    const bool inside = d[i] >= min && d[i] <= max;
    report.specks += speck && inside ? 1 : 0;
    if (!inside || (speck && report.options.drop_specks)) continue;
    kept.push_back(report.set.particles[i]);
    report.speck.push_back(speck);
  }
  const std::size_t outside =
      d.size() - kept.size() - (report.options.drop_specks ? report.specks : 0);
  if (outside > 0) {
    report.set.notes.push_back(
        fmt::format("{} grains outside {:g} to {:g} um are left out", outside, min, max));
  }
  if (report.specks > 0) {
    report.set.notes.push_back(fmt::format(
        "{} specks below {:.3g} um, far from all the rest and without mass{}", report.specks, fence,
        report.options.drop_specks ? ", are left out"
                                   : "; they count by number: --drop-specks leaves them out"));
  }
  report.set.particles = std::move(kept);
}

std::array<Quantity95, 3> shape(const std::vector<double>& values, const Bootstrap& options) {
  std::array<Quantity95, 3> result;
  if (values.empty()) return result;
  const SizeDistribution sample(values, Weighting::number);
  const auto at = sample.quantiles_um(kShares);
  const auto around =
      bootstrap_intervals({values.size()}, options, [&](const std::vector<DrawCounts>& counts) {
        return sample.quantiles_um(kShares, counts[0]);
      });
  for (std::size_t k = 0; k < 3; ++k) result[k] = {at[k], around[k]};
  return result;
}

void quantiles(PsdReport& r, const std::vector<double>& d, std::vector<double> other) {
  r.number.emplace(d, Weighting::number);
  r.mass.emplace(d, Weighting::mass);
  const auto number = r.number->quantiles_um(kShares), mass = r.mass->quantiles_um(kShares);
  const auto around = bootstrap_intervals(
      {d.size()}, r.options.bootstrap, [&](const std::vector<DrawCounts>& counts) {
        auto all = r.number->quantiles_um(kShares, counts[0]);
        const auto by_mass = r.mass->quantiles_um(kShares, counts[0]);
        all.insert(all.end(), by_mass.begin(), by_mass.end());
        return all;
      });
  // What the printed digits leave open shifts all grains together.
  const double digits =
      digits_um2(r.set.area_step_um2, r.options.diameter == DiameterKind::perimeter);
  const auto widened = [&](const ConfidenceInterval& i) {
    return ConfidenceInterval{i.low - digits / i.low, i.high + digits / i.high};
  };
  for (std::size_t k = 0; k < 3; ++k) {
    r.by_number[k] = {number[k], widened(around[k])};
    r.by_mass[k] = {mass[k], widened(around[k + 3])};
  }
  r.d50_other = shape(other, r.options.bootstrap)[1];
}

void fits(PsdReport& r) {
  const double min = std::max(r.options.min_um, r.number->diameters_um().front());
  const double max = std::min(r.options.max_um, r.number->diameters_um().back());
  const RosinRammler cut{0, 0, min, max, 0.0}, foam{0, 0, min, max, min};
  r.rr_number = fit_rosin_rammler(*r.number);
  r.rr_mass = fit_rosin_rammler(*r.mass);
  r.cut_number = fit_rosin_rammler(*r.number, cut);
  r.cut_mass = fit_rosin_rammler(*r.mass, cut);
  r.foam_number = nearest_rosin_rammler(*r.number, foam);
  r.foam_mass = nearest_rosin_rammler(*r.mass, foam);
  const auto fit = [](const std::optional<RosinRammlerFit>& f) { return f && f->fits(); };
  if (fit(r.rr_number) || fit(r.cut_number) || fit(r.rr_mass) || fit(r.cut_mass)) return;
  r.set.notes.push_back(
      "no Rosin-Rammler law fits these sizes: "
      "in.powder and sizeDistribution have them as measured");
}

}  // namespace

double diameter_um(const Particle& p, DiameterKind kind) {
  return kind == DiameterKind::area ? p.area_diameter_um() : p.perimeter_diameter_um();
}

PsdReport analyse_sizes(const std::vector<fs::path>& files, const PsdOptions& options,
                        const PictureProgress& progress) {
  PsdReport r;
  r.options = options;
  GrainSource source =
      read_grain_source(files, options.pixel_size_um, options.segmentation, progress);
  r.set = std::move(source.set);
  r.overlays = std::move(source.overlays);
  r.set.notes.insert(r.set.notes.end(), r.set.perimeter_notes.begin(), r.set.perimeter_notes.end());
  flag_specks(r);
  const std::size_t n = r.set.particles.size();
  if (n < 2) {
    throw InvalidInput("particle sizes", fmt::format("{} grain{}", n, n == 1 ? "" : "s"),
                       "two grains or more; some hundred for intervals of a few per cent",
                       "measure more pictures, or widen --min-diameter-um and --max-diameter-um");
  }
  if (n < kFewGrains)
    r.set.notes.push_back(fmt::format("only {} grains: the intervals are too narrow", n));
  std::vector<double> d, other, circularity, aspect;
  for (const Particle& p : r.set.particles) {
    d.push_back(diameter_um(p, options.diameter));
    other.push_back(diameter_um(
        p, options.diameter == DiameterKind::area ? DiameterKind::perimeter : DiameterKind::area));
    circularity.push_back(p.circularity());
    if (p.aspect_ratio) aspect.push_back(*p.aspect_ratio);
  }
  quantiles(r, d, std::move(other));
  r.circularity = shape(circularity, options.bootstrap);
  r.aspect_ratio = shape(aspect, options.bootstrap);
  r.with_aspect_ratio = aspect.size();
  fits(r);
  if (!r.overlays.empty() && r.by_number[1].value < kSmallMedian_px * *r.set.pixel_size_um) {
    r.set.notes.push_back(
        fmt::format("the median grain has {:.2g} pixels only: sizes are uncertain by their edges; "
                    "use a higher magnification",
                    r.by_number[1].value / *r.set.pixel_size_um));
  }
  return r;
}

}  // namespace powderlink::analysis
