// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/flow/flow_figures.h"

#include <fmt/format.h>
#include <unistd.h>

#include <cstdlib>
#include <fstream>
#include <sstream>

#include "analysis/kat/child_process.h"
#include "analysis/write_file.h"
#include "models/invalid_input.h"

namespace powderlink::analysis {

namespace fs = std::filesystem;

namespace {

constexpr double kLimit_s = 120.0;

fs::path script_folder() {
  const char* given = std::getenv("POWDERLINK_PLOTS");
  return given != nullptr && *given != '\0' ? fs::path(given) : fs::path(POWDERLINK_PLOT_SCRIPTS);
}

bool have_gnuplot() {
  const char* path = std::getenv("PATH");
  std::istringstream folders(path != nullptr ? path : "");
  std::string folder;
  while (std::getline(folders, folder, ':')) {
    if (::access((folder + "/gnuplot").c_str(), X_OK) == 0) return true;
  }
  return false;
}

std::string content_of(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  std::ostringstream text;
  text << in.rdbuf();
  return text.str();
}

void replace_all(std::string& text, const std::string& from, const std::string& to) {
  for (std::size_t at = 0; (at = text.find(from, at)) != std::string::npos; at += to.size()) {
    text.replace(at, from.size(), to);
  }
}

/// A folder for drafts that vanishes.
class Drafts {
 public:
  explicit Drafts(const fs::path& out) : path_(out / fmt::format(".drafts{}", ::getpid())) {
    fs::create_directories(path_);
  }
  ~Drafts() {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
  }
  Drafts(const Drafts&) = delete;
  Drafts& operator=(const Drafts&) = delete;
  const fs::path& path() const { return path_; }

 private:
  fs::path path_;
};

}  // namespace

std::vector<std::string> draw_flow_figures(const FlowReport& report, const fs::path& out) {
  if (!have_gnuplot()) return {"no figures: gnuplot is not in PATH; install gnuplot-nox"};
  const fs::path scripts = fs::absolute(script_folder());
  if (!fs::is_regular_file(scripts / "style.gp")) {
    throw InvalidInput("drawing figures", scripts.string(),
                       "the folder scripts/plots of powderlink",
                       "name it in the variable POWDERLINK_PLOTS, or give --no-figures");
  }
  const FlowWindow& window = report.options.window;
  const std::string common = fmt::format(
      "slope={:.9g}; intercept={:.9g}; from_z={:.9g}; to_z={:.9g}; from_s={:.9g}; "
      "mean_flow={:.9g}; rms={:.9g}; average_ms={:g}",
      report.slope ? report.slope->slope_Pa_m : 0.0,
      report.slope ? report.slope->intercept_Pa : 0.0, window.from_z_m,
      std::min(window.to_z_m, 1e3), window.from_s, report.mean_flow_kg_s.value_or(0.0),
      report.irregularity ? report.irregularity->rms_percent : -1.0,
      1e3 * report.options.average_s);
  const Drafts drafts(out);
  for (const char* name :
       {"pressure", "solids_flow", "height", "velocity", "width", "concentration"}) {
    const fs::path table = fs::absolute(out / (std::string(name) + ".csv"));
    if (!fs::is_regular_file(table)) continue;
    const fs::path draft = fs::absolute(drafts.path() / "figure.svg");
    const fs::path messages = drafts.path() / "messages";
    const ChildOutcome outcome =
        run_child({"gnuplot", "-e",
                   fmt::format("{}; table='{}'; output='{}'; load '{}'", common, table.string(),
                               draft.string(), (scripts / "style.gp").string()),
                   (scripts / fmt::format("flow_{}.gp", name)).string()},
                  drafts.path(), fs::absolute(messages), kLimit_s);
    if (outcome.exit_status != 0 || outcome.over_time || !fs::is_regular_file(draft)) {
      throw InvalidInput(fmt::format("drawing {}.svg", name), content_of(messages),
                         "tables that gnuplot can draw", "look at the table, or give --no-figures");
    }
    std::string svg = content_of(draft);
    // Keeps blanks at a change of font, and italics in the family of the rest, in every viewer.
    replace_all(svg, "<text>", "<text xml:space=\"preserve\">");
    replace_all(svg, "font-family=\"Helvetica\" ",
                "font-family=\"Helvetica,Arial,DejaVu Sans,sans-serif\" ");
    write_file(out / fmt::format("{}.svg", name), svg);
    fs::remove(draft);
  }
  return {};
}

}  // namespace powderlink::analysis
