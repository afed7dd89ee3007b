// SPDX-License-Identifier: GPL-3.0-or-later
// diagnose_sets FOLDER [JOBS [--check]]: `powderlink diagnose` for every study of FOLDER/truth.csv in
// one process; writes FOLDER/verdicts.csv and prints the confusion matrix and the rates of
// docs/diagnosis.md. --check: status 1 when a rate misses its target.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <map>
#include <set>
#include <thread>

#include "analysis/evidence/diagnosis.h"
#include "base/csv/csv_table.h"
#include "base/files/write_file.h"
#include "base/text/text_table.h"

namespace {

using namespace powderlink;
using namespace powderlink::analysis;

struct Outcome {
  std::string hidden, verdict, best, first;
  std::vector<std::string> indistinguishable;
  std::string detail;

  bool outside() const { return hidden == "step" || hidden == "wave"; }
  bool alone() const { return verdict == "missing_effect" && best == hidden; }
  bool named() const {
    return alone() || best == hidden ||
           std::find(indistinguishable.begin(), indistinguishable.end(), hidden) !=
               indistinguishable.end();
  }
  /// Column of the matrix.
  std::string answer() const {
    if (verdict == "missing_effect") return best;
    if (verdict == "ambiguous") return named() ? "ambiguous, with it" : "ambiguous, without";
    return verdict;
  }
};

Outcome examine(const std::filesystem::path& study_file) {
  const Study study = read_study(study_file);
  const Observations observations = observe(study);
  const Diagnosis d = diagnose(study, observations);
  Outcome o;
  o.verdict = to_string(d.verdict);
  o.best = d.best;
  o.indistinguishable = d.indistinguishable;
  for (const Candidate& c : d.ranking) {
    o.detail += fmt::format(" {}:{:.1f}/{:.2g}/{:.1g}", c.name, c.bic - d.baseline().bic,
                            c.chi2_per_dof(), least_p_value(c.tests));
  }
  for (const Pattern& p : d.patterns) {
    o.detail += fmt::format(" {}:{:.1f}", p.name, pattern_bic(p, observations) - d.baseline().bic);
  }
  return o;
}

/// What a rate must be.
struct Target {
  enum class Kind { at_least, at_most } kind;
  double part;
  /// A table of few sets may have one of what is allowed at all.
  bool holds(int hits, int all) const {
    if (kind == Kind::at_least) return hits >= part * all;
    return hits <= std::max(part * all, part > 0.0 ? 1.0 : 0.0);
  }
  std::string text() const {
    return part == 0.0 ? "never"
                       : fmt::format("{} {:g} %", kind == Kind::at_least ? "at least" : "at most",
                                     100.0 * part);
  }
};
constexpr Target at_least(double part) { return {Target::Kind::at_least, part}; }
constexpr Target at_most(double part) { return {Target::Kind::at_most, part}; }
constexpr Target kNever = at_most(0.0);

/// Returns whether all rates reach their targets.
bool print(const std::vector<Outcome>& outcomes) {
  std::vector<std::string> rows;
  std::set<std::string> answers;
  std::map<std::string, std::map<std::string, int>> counts;
  for (const Outcome& o : outcomes) {
    if (std::find(rows.begin(), rows.end(), o.hidden) == rows.end()) rows.push_back(o.hidden);
    ++counts[o.hidden][o.answer()];
    answers.insert(o.answer());
  }
  std::vector<std::string> header = {"hidden"};
  header.insert(header.end(), answers.begin(), answers.end());
  TextTable table(header);
  for (const std::string& row : rows) {
    std::vector<std::string> cells = {row};
    for (const std::string& answer : answers) {
      const int n = counts[row][answer];
      cells.push_back(n == 0 ? "" : std::to_string(n));
    }
    table.add(cells);
  }
  fmt::print("{}\n", table.text());

  bool good = true;
  const auto rate = [&](const char* what, Target target, auto counted, auto hit) {
    int all = 0;
    int hits = 0;
    for (const Outcome& o : outcomes) {
      if (!counted(o)) continue;
      ++all;
      hits += hit(o) ? 1 : 0;
    }
    if (all == 0) return;
    const bool holds = target.holds(hits, all);
    fmt::print("{:62} {:4} of {:4}  {:5.1f} %  {}: {}\n", what, hits, all, 100.0 * hits / all,
               target.text(), holds ? "holds" : "FAILS");
    good = good && holds;
  };
  const auto none = [](const Outcome& o) { return o.hidden == "none"; };
  const auto effect = [](const Outcome& o) { return o.hidden != "none" && !o.outside(); };
  const auto outside = [](const Outcome& o) { return o.outside(); };
  rate("effect of the catalogue: first or not told apart from the first", at_least(0.90), effect,
       [](const Outcome& o) { return o.named(); });
  rate("effect of the catalogue: named alone", at_least(0.75), effect,
       [](const Outcome& o) { return o.alone(); });
  rate("effect of the catalogue: another named alone", at_most(0.10), effect,
       [](const Outcome& o) { return o.verdict == "missing_effect" && !o.alone(); });
  rate("nothing hidden: false alarm", at_most(0.03), none,
       [](const Outcome& o) { return o.verdict != "no_missing_effect"; });
  rate("outside the catalogue: unexplained or ambiguous", at_least(0.80), outside,
       [](const Outcome& o) { return o.verdict == "unexplained" || o.verdict == "ambiguous"; });
  rate("outside the catalogue: an effect named alone", kNever, outside,
       [](const Outcome& o) { return o.verdict == "missing_effect"; });
  return good;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 2) {
    std::fprintf(stderr, "diagnose_sets FOLDER [JOBS [--check]]\n");
    return 2;
  }
  try {
    const std::filesystem::path folder = argv[1];
    const int jobs = argc > 2 ? std::max(1, std::atoi(argv[2])) : 1;
    const CsvTable truth = read_csv(folder / "truth.csv");
    std::vector<Outcome> outcomes(truth.rows.size());
    std::atomic<std::size_t> next{0};
    std::atomic<bool> failed{false};
    const auto work = [&] {
      for (std::size_t i = next++; i < outcomes.size(); i = next++) {
        try {
          outcomes[i] = examine(folder / (truth.rows[i].cells[0] + ".toml"));
          outcomes[i].hidden = truth.rows[i].cells[1];
        } catch (const std::exception& e) {
          fmt::print(stderr, "{}: {}\n", truth.rows[i].cells[0], e.what());
          failed = true;
          next = outcomes.size();
        }
      }
    };
    std::vector<std::thread> workers;
    for (int j = 0; j < jobs; ++j) workers.emplace_back(work);
    for (std::thread& t : workers) t.join();
    if (failed) return 1;
    std::string text = "set,hidden,verdict,best,indistinguishable,candidates\n";
    for (std::size_t i = 0; i < outcomes.size(); ++i) {
      const Outcome& o = outcomes[i];
      text += fmt::format("{},{},{},{},{},{}\n", truth.rows[i].cells[0], o.hidden, o.verdict,
                          o.best, fmt::join(o.indistinguishable, " "), o.detail);
    }
    write_file(folder / "verdicts.csv", text);
    const bool good = print(outcomes);
    if (argc > 3 && std::string(argv[3]) == "--check") return good ? 0 : 1;
  } catch (const std::exception& e) {
    std::fprintf(stderr, "diagnose_sets: %s\n", e.what());
    return 1;
  }
  return 0;
}
