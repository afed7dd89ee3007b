// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <memory>
#include <nlohmann/json.hpp>

#include "analysis/evidence/diagnosis.h"
#include "analysis/evidence/evidence_json.h"
#include "analysis/evidence/verdict_words.h"
#include "analysis/program/commands.h"
#include "base/files/write_file.h"
#include "base/text/text_table.h"

namespace powderlink::analysis {

namespace {

std::string ranking_table(const Diagnosis& d) {
  TextTable t({"effect", "delta BIC", "rms", "chi^2/dof", "left out", "plausible", "parameters"});
  t.flush_left(6);
  const auto add = [&](const Candidate& c) {
    t.add({c.name, fmt::format("{:+.1f}", c.bic - d.baseline().bic), rms_text(c.rms),
           fmt::format("{:.2f}", c.chi2_per_dof()), rms_text(c.left_out),
           c.plausible ? "yes" : "NO", c.acts ? parameter_text(c) : c.why});
  };
  for (const Candidate& c : d.ranking) add(c);
  for (std::size_t i = 0; i < d.pairs.size() && i < 3; ++i) add(d.pairs[i]);
  return t.text();
}

void run(const std::string& file, const std::string& json) {
  const Study study = read_study(file);
  for (const std::string& note : study.notes) fmt::print(stderr, "powderlink: {}\n", note);
  if (!json.empty()) require_folder_of(json);
  const Observations observations = observe(study);
  const Diagnosis d = diagnose(study, observations);
  if (!json.empty()) write_file(json, json_of(d, observations).dump(1) + "\n");

  fmt::print("{}: {} on {}, {} rows\n\nverdict: {}\n", study.name, study.particle.name,
             study.substrate.name, study.rows.size(), to_string(d.verdict));
  for (const std::string& sentence : d.words) fmt::print("- {}\n", sentence);
  fmt::print("- next measurement: {}\n\n{}", d.next.text, ranking_table(d));
  if (!d.best.empty()) {
    fmt::print("\npowderlink add {} {} -o NEWSTUDY  writes the study with it\n", file, d.best);
  }
}

}  // namespace

void add_diagnose_command(CLI::App& app) {
  CLI::App* c = app.add_subcommand(
      "diagnose",
      "which physical effect is missing from a study, how surely, what to measure next");
  auto study = std::make_shared<std::string>();
  auto json = std::make_shared<std::string>();
  c->add_option("study", *study, "study file (TOML)")->required();
  c->add_option("--json", *json, "write the diagnosis to this file too");
  c->callback([study, json] { run(*study, *json); });
}

}  // namespace powderlink::analysis
