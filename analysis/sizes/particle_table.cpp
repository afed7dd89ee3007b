// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/sizes/particle_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <boost/algorithm/string/predicate.hpp>

#include "analysis/sizes/imagej_perimeter.h"
#include "analysis/sizes/particle_columns.h"
#include "analysis/sizes/table_doubts.h"
#include "base/csv/csv_number.h"
#include "base/invalid_input.h"
#include "base/text/text_encoding.h"

namespace powderlink::analysis {

namespace fs = std::filesystem;

namespace {

constexpr double kSameSize = 1e-6;  // relative: the same pixel size, written with other digits
constexpr std::size_t kLargestFooter = 4;  // rows below those of the grains

constexpr CsvFormat kFormat{
    "table of grains", "check the path", "save the results in ImageJ with column headers",
    "in ImageJ tick \"Save column headers\" in Edit > Options > Input/Output, "
    "and save the results again"};

std::string how_to_scale() {
  return "give --pixel-size-um X, the side of a pixel; "
         "1 when the image had its scale in um and the table is thus in um, 1000 when in mm";
}

/// The scale of one row; `known` is what was given or stated before.
void agree(std::optional<double>& known, double stated, const std::string& where) {
  require_pixel_size_um(stated, where);
  if (known && std::fabs(stated - *known) > kSameSize * *known) {
    throw InvalidInput(where, fmt::format("{:g} um per pixel", stated),
                       fmt::format("{:g} um, as given before: one pixel size in all files", *known),
                       "correct the wrong one, or analyse every magnification by itself");
  }
  known = stated;
}

double positive(const CsvTable& table, const CsvTable::Row& row, std::size_t column) {
  const double value = table.number(row, column);
  if (value > 0.0) return value;
  const bool lost = value == 0.0 && row.cells[column].find_first_of(".,") != std::string::npos;
  throw InvalidInput(table.place(row, column), row.cells[column], "a number above 0",
                     lost ? "in ImageJ raise \"Decimal places\" or tick \"Scientific notation\" "
                            "in Analyze > Set Measurements, "
                            "or give the unit um in Analyze > Set Scale"
                          : "remove the row");
}

/// Area and perimeter in the table's unit.
Particle read_row(const CsvTable& table, const ParticleColumns& columns, const CsvTable::Row& row) {
  Particle p;
  p.place = row.line;
  p.area_um2 = positive(table, row, columns.area);
  if (columns.perimeter) {
    p.perimeter_um = positive(table, row, *columns.perimeter);
  } else {
    p.perimeter_um = std::sqrt(4.0 * boost::math::constants::pi<double>() * p.area_um2 /
                               positive(table, row, *columns.circularity));
  }
  p.aspect_ratio = number_or_nothing(table, row, columns.aspect_ratio);
  if (!p.aspect_ratio) {
    const auto round = number_or_nothing(table, row, columns.roundness);
    if (round && *round > 0.0) p.aspect_ratio = std::max(1.0, 1.0 / *round);
  }
  p.feret_um = number_or_nothing(table, row, columns.feret);
  return p;
}

/// Takes out the rows that ImageJ's Results > Summarize appends; they are no grains.
void drop_summary(CsvTable& table, ParticleSet& set) {
  std::vector<std::size_t> names;  // where ImageJ writes the word, by version and options
  for (std::size_t c = 0; c < table.columns.size(); ++c) {
    if (table.columns[c].empty() || boost::algorithm::iequals(table.columns[c], "label"))
      names.push_back(c);
  }
  const std::size_t all = table.rows.size();
  const auto is_summary = [&](const CsvTable::Row& row) {
    return std::any_of(names.begin(), names.end(), [&](std::size_t c) {
      const std::string& cell = row.cells[c];
      return cell == "Mean" || cell == "SD" || cell == "Min" || cell == "Max";
    });
  };
  table.rows.erase(std::remove_if(table.rows.begin(), table.rows.end(), is_summary),
                   table.rows.end());
  if (table.rows.empty()) {
    throw InvalidInput(table.file, "a summary (Mean, SD, Min, Max) and no grains",
                       "one row per grain", "save the results, not only their summary");
  }
  if (table.rows.size() == all) return;
  set.notes.push_back(
      fmt::format("{}: {} rows of ImageJ's Summarize (Mean, SD, Min, Max) are left out", table.file,
                  all - table.rows.size()));
}

/// Takes out what users of spreadsheets append: "Sum" or "Average" where the rows above have numbers.
void drop_footer(CsvTable& table, ParticleSet& set) {
  const std::optional<std::size_t> names = table.find_column("");
  if (!names) return;
  const auto numbered = [&](const CsvTable::Row& row) {
    return number_form(row.cells[*names]).number;
  };
  const auto end = std::find_if_not(table.rows.begin(), table.rows.end(), numbered);
  if (end == table.rows.begin() || std::any_of(end, table.rows.end(), numbered)) return;
  const auto left_out = static_cast<std::size_t>(table.rows.end() - end);
  const bool named = std::any_of(end, table.rows.end(), [&](const CsvTable::Row& row) {
    return row.cells[*names].find_first_of("0123456789") != std::string::npos;
  });
  if (left_out == 0 || left_out > kLargestFooter || named) return;
  set.notes.push_back(
      fmt::format("{}, line {}: '{}' below rows with a number is no grain; {} of {} rows left out",
                  table.file, end->line, end->cells[*names], left_out, table.rows.size()));
  table.rows.erase(end, table.rows.end());
}

double median_diameter(const std::vector<Particle>& particles) {
  std::vector<double> d;
  d.reserve(particles.size());
  for (const Particle& p : particles) d.push_back(p.area_diameter_um());
  const auto middle = d.begin() + static_cast<long>(d.size() / 2);
  std::nth_element(d.begin(), middle, d.end());
  return *middle;
}

/// ImageJ writes no unit: a table without one whose grains are smaller than a pixel is in mm or um.
void check_scale(const std::string& file, const std::optional<double>& scale,
                 const std::vector<Particle>& particles, ParticleSet& set) {
  constexpr double um = 1.0, mm = 1000.0;
  constexpr double seen_um = 0.2;  // less than light resolves
  const double middle = median_diameter(particles);
  const std::string would = fmt::format(
      "give --pixel-size-um 1000 when the image had its scale in mm, which makes them {:.3g} um",
      mm * middle);
  if (!scale) {
    throw InvalidInput(file + ", pixel size",
                       middle < 1.0 ? fmt::format("no scale, and grains of {:.3g} in the middle: "
                                                  "less than a pixel",
                                                  middle)
                                    : "a table in pixels without a scale",
                       "a side of the pixel in um, as option, comment or column",
                       middle < 1.0 ? would + "; 1 when in um" : how_to_scale());
  }
  if (middle >= 1.0 || *scale == mm) return;
  if (*scale != um) {
    throw InvalidInput(
        file + ", pixel size",
        fmt::format("{:g} um, and grains of {:.3g} pixels in the middle", *scale, middle),
        "grains of a pixel or more", would + "; 1 when in um");
  }
  if (middle < seen_um) {
    set.notes.push_back(
        fmt::format("{}: half of the grains are below {:.2g} um: {}", file, middle, would));
  }
}

bool all_whole(const std::vector<Particle>& particles) {
  return std::all_of(particles.begin(), particles.end(),
                     [](const Particle& p) { return p.area_um2 == std::floor(p.area_um2); });
}

/// The side of a pixel in the table's unit, where it is known. A scale of 1 may mean a table in um.
std::optional<double> pixel_of(const ParticleColumns& columns, std::optional<double> scale,
                               const std::vector<Particle>& particles) {
  constexpr double least_px = 2.0;  // of the median grain: below it the unit is no pixel
  if (scale == 1.0 && !all_whole(particles)) return std::nullopt;
  if (columns.unit_um) return scale ? std::optional(*scale / *columns.unit_um) : std::nullopt;
  if (all_whole(particles)) return 1.0;
  return median_diameter(particles) < least_px ? std::nullopt : std::optional(1.0);
}

/// Whether perimeters may be those that ImageJ traces along the pixels: never whole numbers, as at least
/// two corners are cut, and never shorter than those of a disk as ImageJ sees it.
bool may_be_traced(const std::vector<Particle>& particles, double pixel) {
  constexpr double least_px = 15.0, scatter = 0.985, exact_px = 1e-6;
  std::size_t judged = 0, others = 0;
  for (const Particle& p : particles) {
    const double d = p.area_diameter_um() / pixel, edge = p.perimeter_um / pixel;
    const bool whole = std::fabs(edge - std::round(edge)) < exact_px;
    if (!whole && d < least_px) continue;
    ++judged;
    others += whole || edge < scatter * imagej_perimeter_px(d) ? 1 : 0;
  }
  return 2 * others <= judged;
}

/// Perimeters of ImageJ, without its bias where the pixel is known.
void correct_perimeters(const RawTable& raw, std::vector<Particle>& particles, ParticleSet& set) {
  constexpr double exact = 0.97;  // circularity that ImageJ finds below 13 pixels only
  if (!raw.columns.imagej) return;
  std::string note;
  if (raw.pixel && may_be_traced(particles, *raw.pixel)) {
    for (Particle& p : particles)
      p.perimeter_um = *raw.pixel * edge_of_imagej_px(p.perimeter_um / *raw.pixel);
    note = fmt::format(
        "Perim. is ImageJ's, {:g} p - {:g} pixels for an edge of p pixels; "
        "p is used, so that circularities are not those of Circ.",
        kImagejSlope, kImagejOffset_px);
  } else if (!raw.pixel && median_circularity(particles) < exact) {
    note =
        "Perim. is ImageJ's, up to 5.5 % too long, and 4A/P up to 5 % too small: "
        "the size of a pixel, which is not known, would tell by how much. "
        "Measure in pixels (Analyze > Set Scale > Click to Remove Scale) and give --pixel-size-um, "
        "or take --diameter area";
  }
  std::vector<std::string>& notes = set.perimeter_notes;
  if (!note.empty() && std::find(notes.begin(), notes.end(), note) == notes.end())
    notes.push_back(std::move(note));
}

void judge_table(const RawTable& raw, const std::optional<double>& scale, ParticleSet& set) {
  // Digits first: too few of them make shapes that cannot be, and no scale mends them.
  const double step = raw.unit_um * raw.unit_um * check_digits(raw, set.notes);
  set.area_step_um2 = std::max(set.area_step_um2, step);
  if (!raw.columns.unit_um) check_scale(raw.table.file, scale, raw.particles, set);
  for (std::string& note : check_shapes(raw)) set.notes.push_back(std::move(note));
  if (!raw.columns.perimeter)
    set.notes.push_back(raw.table.file + ": no Perim.; perimeters are taken from Circ.");
  const bool known = raw.columns.unit_um || scale == 1.0 || all_whole(raw.particles);
  if (!known && raw.pixel) {
    set.notes.push_back(
        fmt::format("{}: areas are not whole numbers of pixels; "
                    "if the table is in um already, give --pixel-size-um 1 (now {:g})",
                    raw.table.file, *scale));
  }
}

/// Returns the size of a pixel in um where it is sure.
std::optional<double> read_table(const fs::path& file, const std::optional<double>& given,
                                 ParticleSet& set) {
  CsvTable table = read_csv(file, kFormat);
  drop_summary(table, set);
  drop_footer(table, set);
  const ParticleColumns columns = find_particle_columns(table);
  std::optional<double> scale = given;
  if (const auto stated = stated_pixel_size_um(table))
    agree(scale, *stated, table.file + ", pixel size");
  std::vector<Particle> particles;
  for (const CsvTable::Row& row : table.rows) {
    particles.push_back(read_row(table, columns, row));
    if (columns.pixel_size)
      agree(scale, table.number(row, *columns.pixel_size), table.place(row, *columns.pixel_size));
  }
  if (scale) agree(set.pixel_size_um, *scale, table.file + ", pixel size");
  const double factor = columns.unit_um ? *columns.unit_um : scale.value_or(1.0);
  const RawTable raw{table, columns, particles, pixel_of(columns, scale, particles), factor};
  judge_table(raw, scale, set);
  correct_perimeters(raw, particles, set);
  for (Particle& p : particles) {
    p.file = set.files.size();
    p.area_um2 *= factor * factor;
    p.perimeter_um *= factor;
    if (p.feret_um) *p.feret_um *= factor;
    set.particles.push_back(p);
  }
  set.files.push_back(table.file);
  return raw.pixel ? std::optional(*raw.pixel * factor) : std::nullopt;
}

void note_noise(ParticleSet& set, std::optional<double> pixel_um) {
  if (set.files.empty()) return;
  const std::string where = set.files.size() == 1 ? set.files.front()
                                                  : fmt::format("{} and {} more", set.files.front(),
                                                                set.files.size() - 1);
  const std::string doubt = noise_doubt(set.particles, pixel_um, where);
  if (!doubt.empty()) set.notes.push_back(doubt);
}

}  // namespace

double require_pixel_size_um(double value, const std::string& where) {
  constexpr double smallest = 1e-4, largest = 1e3;
  if (value >= smallest && value <= largest) return value;
  throw InvalidInput(where, fmt::format("{:g}", value),
                     fmt::format("{:g} to {:g} um", smallest, largest),
                     "give the side of one pixel in micrometres");
}

ParticleSet read_particle_tables(const std::vector<fs::path>& files,
                                 const std::optional<double>& pixel_size_um) {
  ParticleSet set;
  if (pixel_size_um) require_pixel_size_um(*pixel_size_um, "option --pixel-size-um");
  std::optional<double> pixel_um;
  bool sure = true;
  for (const fs::path& file : files) {
    pixel_um = read_table(file, pixel_size_um, set);
    sure = sure && pixel_um;
    if (pixel_size_um) set.pixel_size_um = pixel_size_um;
  }
  note_noise(set, sure ? pixel_um : std::nullopt);
  for (std::string& note : set.notes)
    note = for_terminal(note);  // names of files may hold anything
  return set;
}

}  // namespace powderlink::analysis
