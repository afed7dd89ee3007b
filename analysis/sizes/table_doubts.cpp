// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/sizes/table_doubts.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "base/csv/csv_number.h"
#include "base/invalid_input.h"

namespace powderlink::analysis {

namespace {

constexpr double kPi = boost::math::constants::pi<double>();
constexpr double kRounding = 1.02;        // of 4 pi A/P^2 from cells of three digits
constexpr double kUnknownPixel = 1.1;     // bound where grains may have any number of pixels
constexpr double kLeastCounted_px = 5.0;  // smaller: bounds of digital shapes say little
constexpr double kThinnest = 0.01;        // 4 pi A/P^2
constexpr double kLargestStep = 0.02, kFeltStep = 0.002;  // of a diameter, +-
constexpr double kWorst = 0.1;                            // share of the grains that may be worse
constexpr double kRagged = 0.5;                           // circularity of the median grain
constexpr double kFewPixels = 5.0;                        // median diameter
constexpr double kCircDiffers = 0.03;  // of Circ. from 4 pi A/P^2: ImageJ rounds to 0.001

const char* const kNoThousands = "areas with decimal points and without separators of thousands";
const char* const kPlainNumbers =
    "the mark parts thousands: "
    "show the column as plain numbers in the spreadsheet, or take the table as ImageJ saved it";

template <class Value>
double median(std::vector<Value> values) {
  if (values.empty()) return 0.0;
  const auto middle = values.begin() + static_cast<long>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

double largest_ratio(const RawTable& raw, const Particle& p) {
  if (!raw.pixel) return kUnknownPixel;
  const double d = std::max(p.area_diameter_um() / *raw.pixel, kLeastCounted_px);
  return kRounding * d * d / ((d - 1.0) * (d - 1.0));
}

const std::string& area_cell(const RawTable& raw, std::size_t i) {
  return raw.table.rows[i].cells[raw.columns.area];
}

/// Area and perimeter of a row as they stand in the table.
std::string row_text(const RawTable& raw, std::size_t i) {
  const CsvTable::Row& row = raw.table.rows[i];
  const std::size_t other =
      raw.columns.perimeter ? *raw.columns.perimeter : *raw.columns.circularity;
  return fmt::format("{} {} with {} {}: 4 pi A/P^2 is {:.3g}", raw.table.columns[raw.columns.area],
                     area_cell(raw, i), raw.table.columns[other], row.cells[other],
                     isoperimetric_ratio(raw.particles[i]));
}

const char* reason_of_roundness(const RawTable& raw, double middle) {
  constexpr double disk = 4.0 * kPi;  // P^2/A
  if (raw.columns.perimeter)
    return "are Area and Perim. in the same unit, and without separators of thousands? "
           "measure again, or correct the row";
  if (middle > 0.9 * disk && middle < 3.0 * disk)
    return "P^2/A is 12.6 for a disk and another measure: "
           "give Perim., or 4 pi Area/Perim.^2 as Circ.";
  if (middle > 20.0) return "in per cent? divide Circ. by 100, or give Perim.";
  return "the inverse of ImageJ's Circ.? give Perim., or 4 pi Area/Perim.^2 as Circ.";
}

/// Shapes rounder than a disk.
void check_roundest(const RawTable& raw, std::vector<std::string>& notes) {
  std::vector<double> ratios;
  std::vector<std::size_t> beyond;
  for (std::size_t i = 0; i < raw.particles.size(); ++i) {
    const Particle& p = raw.particles[i];
    ratios.push_back(isoperimetric_ratio(p));
    const bool counts = !raw.pixel || p.area_diameter_um() >= kLeastCounted_px * *raw.pixel;
    if (counts && ratios.back() > largest_ratio(raw, p)) beyond.push_back(i);
  }
  if (beyond.empty()) return;
  const std::size_t first = beyond.front();
  const CsvTable::Row& row = raw.table.rows[first];
  const std::size_t column =
      raw.columns.perimeter ? *raw.columns.perimeter : *raw.columns.circularity;
  if (2 * beyond.size() > raw.particles.size()) {
    throw InvalidInput(raw.table.place(row, column),
                       fmt::format("{}, and too large in {} of {} rows", row_text(raw, first),
                                   beyond.size(), raw.particles.size()),
                       fmt::format("at most {:.3g}: no edge is shorter than that of the disk",
                                   largest_ratio(raw, raw.particles[first])),
                       reason_of_roundness(raw, median(ratios)));
  }
  notes.push_back(fmt::format(
      "{}: {}, more than any shape has, in {} of {} rows; they count as disks",
      raw.table.place(row, column), row_text(raw, first), beyond.size(), raw.particles.size()));
}

/// "1.399": one mark with three digits behind, which may part thousands.
bool may_be_grouped(const std::string& cell) { return number_form(cell).grouped; }

/// Areas a thousand times too small, as separators of thousands make them, beside whole numbers.
void check_thousands(const RawTable& raw) {
  constexpr double thousand = 1e3;
  std::size_t whole = 0;
  std::vector<std::size_t> suspects;
  std::vector<double> others;
  for (std::size_t i = 0; i < raw.particles.size(); ++i) {
    const std::string& cell = area_cell(raw, i);
    const NumberForm form = number_form(cell);
    whole += form.same ? 1 : 0;
    const double ratio = isoperimetric_ratio(raw.particles[i]);
    if (may_be_grouped(cell) && ratio < kThinnest) {
      if (thousand * ratio <= largest_ratio(raw, raw.particles[i])) suspects.push_back(i);
    } else if (!form.same && !may_be_grouped(cell)) {
      return;  // 0.912 or 12.25: the mark is a decimal one
    }
  }
  if (suspects.empty() || (whole == 0 && 2 * suspects.size() <= raw.particles.size())) return;
  const std::size_t first = suspects.front();
  throw InvalidInput(
      raw.table.place(raw.table.rows[first], raw.columns.area),
      fmt::format("{}; with 1000 times the area {:.2g}, and so in {} rows", row_text(raw, first),
                  thousand * isoperimetric_ratio(raw.particles[first]), suspects.size()),
      kNoThousands, kPlainNumbers);
}

/// The same where Circ. gives the perimeters, and they thus fit any area: 1.399 below all of 872, 915, ...
void check_thousands_by_form(const RawTable& raw) {
  constexpr std::size_t least = 3;
  std::size_t whole = 0, grouped = 0, first = 0;
  double largest_grouped = 0.0, smallest_whole = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < raw.particles.size(); ++i) {
    const double area = raw.particles[i].area_um2;
    const NumberForm form = number_form(area_cell(raw, i));
    if (form.same) {
      ++whole;
      smallest_whole = std::min(smallest_whole, area);
    } else if (form.grouped) {
      first = grouped++ == 0 ? i : first;
      largest_grouped = std::max(largest_grouped, area);
    } else {
      return;
    }
  }
  if (whole < least || grouped < least || largest_grouped >= smallest_whole) return;
  throw InvalidInput(raw.table.place(raw.table.rows[first], raw.columns.area),
                     fmt::format("{}, one of {} areas with three digits behind the mark "
                                 "and all of them smaller than the {} whole numbers, from {:g} on",
                                 area_cell(raw, first), grouped, whole, smallest_whole),
                     kNoThousands, kPlainNumbers);
}

void check_thinnest(const RawTable& raw) {
  std::vector<std::size_t> beyond;
  for (std::size_t i = 0; i < raw.particles.size(); ++i)
    if (isoperimetric_ratio(raw.particles[i]) < kThinnest) beyond.push_back(i);
  if (2 * beyond.size() <= raw.particles.size()) return;
  throw InvalidInput(
      raw.table.place(raw.table.rows[beyond.front()], raw.columns.area),
      fmt::format("{}, and so little in {} of {} rows", row_text(raw, beyond.front()),
                  beyond.size(), raw.particles.size()),
      fmt::format("{:g} to 1 in most rows", kThinnest),
      "are Area and Perim. in the same unit, "
      "with decimal points and without separators of thousands? correct and save again");
}

/// Digits behind the decimal mark, less the power of ten.
int decimals_of(const std::string& cell) {
  const std::size_t power = cell.find_first_of("eE");
  const std::string digits = cell.substr(0, power);
  const std::size_t mark = digits.find_last_of(".,");
  int decimals = mark == std::string::npos || number_form(cell).same
                     ? 0
                     : static_cast<int>(digits.size() - mark) - 1;
  if (power != std::string::npos)
    if (const auto exponent = number_of(cell.substr(power + 1), DecimalMark::point))
      decimals -= static_cast<int>(*exponent);
  return decimals;
}

}  // namespace

double isoperimetric_ratio(const Particle& p) {
  return 4.0 * kPi * p.area_um2 / (p.perimeter_um * p.perimeter_um);
}

std::vector<std::string> check_shapes(const RawTable& raw) {
  std::vector<std::string> notes;
  check_roundest(raw, notes);
  check_thousands(raw);
  if (!raw.columns.perimeter) check_thousands_by_form(raw);
  check_thinnest(raw);
  if (raw.columns.perimeter && raw.columns.circularity) {
    std::size_t differ = 0;
    for (std::size_t i = 0; i < raw.particles.size(); ++i) {
      const auto circ = number_or_nothing(raw.table, raw.table.rows[i], raw.columns.circularity);
      differ += circ && std::fabs(*circ - raw.particles[i].circularity()) > kCircDiffers ? 1 : 0;
    }
    if (2 * differ > raw.particles.size()) {
      notes.push_back(raw.table.file +
                      ": Circ. is not 4 pi Area/Perim.^2 in most rows; "
                      "are Area and Perim. in the same unit? Circ. is not used");
    }
  }
  return notes;
}

double check_digits(const RawTable& raw, std::vector<std::string>& notes) {
  // ImageJ writes 5.320E-4 beside 0.002: each power has its own step. Without one it is that of the cell
  // with the most digits, as spreadsheets drop zeros at the end.
  std::optional<int> plain_decimals;
  const auto has_power = [&](std::size_t i) {
    return area_cell(raw, i).find_first_of("eE") != std::string::npos;
  };
  for (std::size_t i = 0; i < raw.particles.size(); ++i) {
    if (has_power(i)) continue;
    plain_decimals = std::max(plain_decimals.value_or(0), decimals_of(area_cell(raw, i)));
  }
  if (plain_decimals == 0 && raw.pixel == 1.0) return 0.0;  // counts of pixels
  std::vector<double> steps, parts;
  for (std::size_t i = 0; i < raw.particles.size(); ++i) {
    const int decimals = has_power(i) ? decimals_of(area_cell(raw, i)) : *plain_decimals;
    steps.push_back(std::pow(10.0, -decimals));
    parts.push_back(steps.back() / (4.0 * raw.particles[i].area_um2));
  }
  std::vector<std::size_t> order(parts.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  const auto worst = order.begin() + static_cast<long>(kWorst * static_cast<double>(order.size()));
  std::nth_element(order.begin(), worst, order.end(),
                   [&](std::size_t a, std::size_t b) { return parts[a] > parts[b]; });
  const std::size_t at = *worst;
  const double largest = *std::max_element(steps.begin(), steps.end());
  if (parts[at] < kFeltStep) return largest;
  const std::string known =
      fmt::format("areas in steps of {:g}, as in {}: diameters are known to +-{:.2g} %", steps[at],
                  area_cell(raw, at), 100.0 * parts[at]);
  const char* cure =
      "in ImageJ raise \"Decimal places\" or tick \"Scientific notation\" "
      "in Analyze > Set Measurements, or give the unit um in Analyze > Set Scale, "
      "and measure again";
  if (parts[at] > kLargestStep) {
    throw InvalidInput(raw.table.place(raw.table.rows[at], raw.columns.area), known,
                       fmt::format("digits that tell diameters to +-{:g} %", 100.0 * kLargestStep),
                       cure);
  }
  notes.push_back(raw.table.file + ": " + known +
                  "; the intervals are wider by that. To do: " + cure);
  return largest;
}

double median_circularity(const std::vector<Particle>& particles) {
  std::vector<double> values;
  for (const Particle& p : particles) values.push_back(p.circularity());
  return median(values);
}

std::string noise_doubt(const std::vector<Particle>& particles, std::optional<double> pixel_size_um,
                        const std::string& where) {
  const char* cure =
      "look at the outlines; another threshold (Otsu in Image > Adjust > Threshold), "
      "a smoothed picture, or a least size in Analyze Particles";
  const double round = median_circularity(particles);
  if (round < kRagged) {
    return fmt::format(
        "{}: half of the {} grains have a circularity below {:.2f}: "
        "specks and outlines of noise rather than grains? {}",
        where, particles.size(), round, cure);
  }
  std::vector<double> d;
  for (const Particle& p : particles) d.push_back(p.area_diameter_um());
  if (!pixel_size_um || median(d) >= kFewPixels * *pixel_size_um) return "";
  return fmt::format(
      "{}: half of the {} grains are below {:.2g} pixels: noise rather than grains? {}", where,
      particles.size(), median(d) / *pixel_size_um, cure);
}

}  // namespace powderlink::analysis
