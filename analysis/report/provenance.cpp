// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/report/provenance.h"

#include <fmt/chrono.h>
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <ctime>

#include "analysis/build_commit.h"
#include "base/files/file_text.h"
#include "base/files/sha1.h"
#include "base/process/child_process.h"

namespace powderlink::analysis {

namespace fs = std::filesystem;

namespace {

constexpr double kLimit_s = 20.0;

/// Version of a Debian package; "not installed" when dpkg does not know it.
std::string package_version(const std::string& package) {
  const fs::path answer =
      fs::temp_directory_path() / fmt::format("powderlink-version-{}", ::getpid());
  std::string text;
  try {
    const ChildOutcome outcome = run_child({"dpkg-query", "-W", "-f", "${Version}", package},
                                           fs::temp_directory_path(), answer, kLimit_s);
    if (outcome.exit_status == 0 && !outcome.over_time) text = file_text_or_empty(answer);
  } catch (const std::exception&) {  // no dpkg: another system
    text.clear();
  }
  std::error_code ignored;
  fs::remove(answer, ignored);
  return text.empty() ? "not installed as a package" : text;
}

std::string command_line() {
  std::string line = file_text_or_empty("/proc/self/cmdline");
  while (!line.empty() && line.back() == '\0') line.pop_back();
  std::replace(line.begin(), line.end(), '\0', ' ');
  return line;
}

}  // namespace

std::string date_text() {
  const char* fixed = std::getenv("SOURCE_DATE_EPOCH");
  const std::time_t now = fixed != nullptr && *fixed != '\0'
                              ? static_cast<std::time_t>(std::strtoll(fixed, nullptr, 10))
                              : std::time(nullptr);
  return fmt::format("{:%Y-%m-%d %H:%M:%S} UTC", fmt::gmtime(now));
}

Facts provenance(const std::string& version, const std::vector<fs::path>& inputs) {
  Facts facts = {{"date", date_text()},
                 {"command", command_line()},
                 {"powderlink", version},
                 {"commit of the build", POWDERLINK_COMMIT},
                 {"program, SHA-1", sha1(file_text("/proc/self/exe"))}};
  for (const char* package : {"liggghts", "openfoam", "libceres3", "gnuplot-nox"})
    facts.emplace_back(fmt::format("{} (Debian package)", package), package_version(package));
  for (const fs::path& file : inputs)
    facts.emplace_back("input, SHA-1: " + file.string(), sha1(file_text(file)));
  return facts;
}

}  // namespace powderlink::analysis
