// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/kat/experiment/drop_study.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "analysis/kat/study/study.h"
#include "analysis/kat/study/study_material.h"
#include "base/csv/csv_plain.h"
#include "base/files/file_text.h"
#include "base/files/write_file.h"
#include "base/toml/toml_text.h"

namespace powderlink::analysis {

namespace fs = std::filesystem;

namespace {

const char* kTime = "contact_time_us";

std::vector<std::string> columns(const KatDrop& drop) {
  std::vector<std::string> names = {"impact_velocity_m_s", "critical_diameter_um",
                                    "critical_diameter_sigma_um"};
  if (drop.contact_time_s) names.emplace_back(kTime);
  return names;
}

std::string row_text(const KatAnalysis& a) {
  const Estimate& d = a.retention.critical;
  const double sigma = d.value * std::log(d.high / d.low) / (2.0 * kNormal95);
  std::string text =
      fmt::format("{:.9g},{:.6g},{:.6g}", a.drop.best.impact_velocity_m_s, d.value, sigma);
  if (a.drop.best.contact_time_s) text += fmt::format(",{:.6g}", 1e6 * *a.drop.best.contact_time_s);
  return text;
}

std::string new_study(const fs::path& study, const fs::path& table, const KatDrop& drop) {
  std::string text = fmt::format(
      "# Drops evaluated by powderlink kat analyse\n[study]\nname = {}\n"
      "experiment = \"kat_critical_diameter\"\nmeasurements = {}\n",
      quoted(study.stem().string()), quoted(table.filename().string()));
  text += material_text("particle", drop.particle) + material_text("substrate", drop.substrate);
  text += "\n[model]\n";
  text += "effects = []  # an instant stop; powderlink diagnose tells what is missing\n";
  if (drop.contact_time_s) {
    text += fmt::format(
        "# With finite_stop_pulse (powderlink add) contact_time_us of the table is its tau_s"
        "{}\n",
        drop.plate_rebound > 0.0
            ? fmt::format("; plate_restitution = {:.9g} was given", drop.plate_rebound)
            : "");
  }
  return text + "\n[fit]\nadhesive_energy_J_m2 = [0.001, 1000.0]\n";
}

void require_same_pair(const Study& old, const KatDrop& drop, const fs::path& file) {
  if (same_material(old.particle, drop.particle) && same_material(old.substrate, drop.substrate))
    return;
  const auto pair = [](const physics::Material& a, const physics::Material& b) {
    return material_words(a) + " on " + material_words(b);
  };
  throw InvalidInput(file.string(), pair(drop.particle, drop.substrate),
                     pair(old.particle, old.substrate) + ", as its drops so far",
                     "name another study with --study");
}

}  // namespace

DropStudy::DropStudy(fs::path study, const KatAnalysis& a)
    : study_(std::move(study)), table_(fs::path(study_).replace_extension(".csv")) {
  if (study_ == table_) {
    throw InvalidInput("--study", study_.string(), "a name that ends in .toml",
                       "name the study; its table is written beside it as .csv");
  }
  require_folder_of(study_);
  const KatDrop& drop = a.drop.best;
  const std::string header = fmt::format("{}", fmt::join(columns(drop), ","));
  const std::string row = row_text(a);
  if (!fs::exists(study_)) {
    if (fs::exists(table_)) {
      throw InvalidInput("--study", table_.string() + ", which exists without its study",
                         "a name of which neither .toml nor .csv exists, or both do",
                         "move the table away, or name another study");
    }
    study_text_ = new_study(study_, table_, drop);
    table_text_ = "# Drops evaluated by powderlink kat analyse\n" + header + "\n" + row + "\n";
    rows_ = 1;
    return;
  }
  const Study old = read_study(study_);
  require_same_pair(old, drop, study_);
  const CsvTable table = read_csv(table_);
  if (table.columns != columns(drop)) {
    throw InvalidInput(
        table_.string(), header,
        fmt::format("the columns of its drops so far: {}", fmt::join(table.columns, ",")),
        "give the time of contact of all drops of a study or of none");
  }
  for (const CsvTable::Row& r : table.rows) {
    if (plain_row(table, r) != row) continue;
    throw InvalidInput(fmt::format("{}, line {}", table_.string(), r.line), row, "every drop once",
                       "leave --study away when a drop is evaluated again");
  }
  // A spreadsheet may have saved it in its own form since.
  table_text_ = plain_csv(table, file_text(table_)) + row + "\n";
  rows_ = static_cast<int>(table.rows.size()) + 1;
}

void DropStudy::write() const {
  write_file(table_, table_text_);
  if (!study_text_.empty()) write_file(study_, study_text_);
}

}  // namespace powderlink::analysis
