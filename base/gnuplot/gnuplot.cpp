// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/gnuplot/gnuplot.h"

#include <fmt/format.h>
#include <unistd.h>

#include <cstdlib>
#include <regex>
#include <sstream>

#include "base/files/file_text.h"
#include "base/files/write_file.h"
#include "base/invalid_input.h"
#include "base/process/child_process.h"

namespace powderlink {

namespace fs = std::filesystem;

namespace {

constexpr double kLimit_s = 120.0;

fs::path script_folder() {
  const char* given = std::getenv("POWDERLINK_PLOTS");
  return fs::absolute(given != nullptr && *given != '\0' ? fs::path(given)
                                                         : fs::path(POWDERLINK_PLOT_SCRIPTS));
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

bool have_gnuplot() {
  const char* path = std::getenv("PATH");
  std::istringstream folders(path != nullptr ? path : "");
  std::string folder;
  while (std::getline(folders, folder, ':')) {
    if (::access((folder + "/gnuplot").c_str(), X_OK) == 0) return true;
  }
  return false;
}

std::string gnuplot_string(const std::string& text) {
  std::string quoted = "'";
  for (const char c : text) {
    if (c == '\'') quoted += c;  // doubled: the quote itself
    quoted += static_cast<unsigned char>(c) < ' ' ? ' ' : c;
  }
  return quoted + "'";
}

std::string mended_svg(std::string svg) {
  replace_all(svg, "<text>", "<text xml:space=\"preserve\">");
  replace_all(svg, "font-family=\"Helvetica\" ",
              "font-family=\"Helvetica,Arial,DejaVu Sans,sans-serif\" ");
  // gnuplot's tooltips call a script of its own and leave the standard element empty.
  static const std::regex hover(
      R"re(<g onmousemove="gnuplot_svg\.showHypertext\(evt,'([^"]*)'\)" onmouseout="[^"]*"><title> </title>)re");
  svg = std::regex_replace(svg, hover, "<g class=\"point\"><title>$1</title>");
  // Names that gnuplot gives to plots without one would show up on hover.
  static const std::regex unnamed(R"(<title>(Gnuplot|gnuplot_plot_[0-9]+[a-z]?)</title>)");
  return std::regex_replace(svg, unnamed, "");
}

void draw_figure(const fs::path& svg, const std::string& script, const std::string& definitions,
                 const std::string& instead) {
  const fs::path scripts = script_folder();
  if (!fs::is_regular_file(scripts / "style.gp")) {
    throw InvalidInput("drawing figures", scripts.string(),
                       "the folder scripts/plots of powderlink",
                       "name it in the variable POWDERLINK_PLOTS, or " + instead);
  }
  const Drafts drafts(fs::absolute(svg).parent_path());
  const fs::path draft = drafts.path() / "figure.svg";
  const fs::path messages = drafts.path() / "messages";
  const ChildOutcome outcome =
      run_child({"gnuplot", "-e",
                 fmt::format("{}; scripts={}; output={}; load {}", definitions,
                             gnuplot_string(scripts.string()), gnuplot_string(draft.string()),
                             gnuplot_string((scripts / "style.gp").string())),
                 (scripts / script).string()},
                drafts.path(), messages, kLimit_s);
  if (outcome.exit_status != 0 || outcome.over_time || !fs::is_regular_file(draft)) {
    const fs::path kept = svg.string() + ".messages";
    write_file(kept, file_text_or_empty(messages));
    throw InvalidInput("drawing " + svg.filename().string(),
                       "gnuplot could not; its messages are in " + kept.string(),
                       "tables that gnuplot can draw", "look at the table, or " + instead);
  }
  write_file(svg, mended_svg(file_text(draft)));
}

}  // namespace powderlink
