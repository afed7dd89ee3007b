// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/particles/particle_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <boost/algorithm/string/predicate.hpp>

#include "analysis/particles/particle_columns.h"
#include "models/invalid_input.h"

namespace powderlink::analysis {

namespace fs = std::filesystem;

namespace {

constexpr double kSameSize = 1e-6;     // relative: the same pixel size, written with other digits
constexpr double kCircDiffers = 0.03;  // of Circ. from 4 pi A/P^2: ImageJ rounds to 0.001

constexpr CsvFormat kFormat{"table of grains", "check the path",
                            "save the results in ImageJ with column headers", true};

std::string how_to_scale() {
  return "give --pixel-size-um X, the side of a pixel; 1 when the image had its scale in um and "
         "the "
         "table is thus in um";
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

std::optional<double> optional_number(const CsvTable& table, const CsvTable::Row& row,
                                      const std::optional<std::size_t>& column) {
  if (!column || row.cells[*column].empty() || boost::algorithm::iequals(row.cells[*column], "nan"))
    return std::nullopt;  // ImageJ's word for shapes without area or axis
  return table.number(row, *column);
}

double positive(const CsvTable& table, const CsvTable::Row& row, std::size_t column) {
  const double value = table.number(row, column);
  if (value > 0.0) return value;
  throw InvalidInput(table.place(row, column), row.cells[column], "a number above 0",
                     "remove the row");
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
  p.aspect_ratio = optional_number(table, row, columns.aspect_ratio);
  if (!p.aspect_ratio) {
    const auto round = optional_number(table, row, columns.roundness);
    if (round && *round > 0.0) p.aspect_ratio = std::max(1.0, 1.0 / *round);
  }
  p.feret_um = optional_number(table, row, columns.feret);
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

void judge_table(const CsvTable& table, const ParticleColumns& columns,
                 const std::vector<Particle>& particles, double scale, ParticleSet& set) {
  if (!columns.perimeter) {
    set.notes.push_back(table.file + ": no Perim.; perimeters are taken from Circ.");
  } else if (columns.circularity) {
    std::size_t differ = 0;
    for (std::size_t i = 0; i < particles.size(); ++i) {
      const auto circ = optional_number(table, table.rows[i], columns.circularity);
      differ += circ && std::fabs(*circ - particles[i].circularity()) > kCircDiffers ? 1 : 0;
    }
    if (2 * differ > particles.size()) {
      set.notes.push_back(table.file +
                          ": Circ. is not 4 pi Area/Perim.^2 in most rows; are Area and Perim. in "
                          "the same unit? Circ. is not used");
    }
  }
  const bool whole = std::all_of(particles.begin(), particles.end(), [](const Particle& p) {
    return p.area_um2 == std::floor(p.area_um2);
  });
  if (!columns.in_um && !whole && scale != 1.0) {
    set.notes.push_back(fmt::format(
        "{}: areas are not whole numbers of pixels; if the table is in um already, give "
        "--pixel-size-um 1 (now {:g})",
        table.file, scale));
  }
}

void read_table(const fs::path& file, const std::optional<double>& given, ParticleSet& set) {
  CsvTable table = read_csv(file, kFormat);
  drop_summary(table, set);
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
  if (!columns.in_um && !scale) {
    throw InvalidInput(table.file + ", pixel size", "a table in pixels without a scale",
                       "a side of the pixel in um, as option, comment or column", how_to_scale());
  }
  if (scale) agree(set.pixel_size_um, *scale, table.file + ", pixel size");
  const double factor = columns.in_um ? 1.0 : *scale;
  judge_table(table, columns, particles, factor, set);
  for (Particle& p : particles) {
    p.file = set.files.size();
    p.area_um2 *= factor * factor;
    p.perimeter_um *= factor;
    if (p.feret_um) *p.feret_um *= factor;
    set.particles.push_back(p);
  }
  set.files.push_back(table.file);
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
  for (const fs::path& file : files) {
    read_table(file, pixel_size_um, set);
    if (pixel_size_um) set.pixel_size_um = pixel_size_um;
  }
  return set;
}

}  // namespace powderlink::analysis
