// SPDX-License-Identifier: GPL-3.0-or-later
// The powderlink program. Exit status: 0 done, 1 the input or a run was wrong, 2 usage.
#include <CLI/CLI.hpp>
#include <cstdio>
#include <exception>

#include "analysis/program/commands.h"
#include "base/statistics/library_logs.h"
#include "base/text/text_encoding.h"

namespace {

constexpr int kFailed = 1;
constexpr int kUsage = 2;

/// Returns the exit status; errors other than of usage are thrown.
int run(int argc, char** argv) {
  namespace analysis = powderlink::analysis;
  CLI::App app{"powderlink: adhesion and flow of metal powder with LIGGGHTS and OpenFOAM",
               "powderlink"};
  app.set_version_flag("--version", "powderlink " POWDERLINK_VERSION);
  app.require_subcommand(1);
  app.footer("powderlink SUBCOMMAND --help tells more. Example studies: kat_cases/.");
  CLI::App* kat = app.add_subcommand("kat", "the Kinetic Adhesion Test");
  kat->require_subcommand(1);
  analysis::add_kat_theory_command(*kat);
  analysis::add_kat_run_command(*kat);
  analysis::add_kat_analyse_command(*kat);
  analysis::add_kat_device_command(*kat);
  analysis::add_compare_command(app);
  analysis::add_contact_command(app);
  analysis::add_diagnose_command(app);
  analysis::add_add_command(app);
  analysis::add_effects_command(app);
  analysis::add_flow_command(app);
  analysis::add_psd_command(app);
  analysis::add_report_command(app);
  analysis::add_restart_command(app);
  // Names and numbers of users may hold anything.
  app.failure_message([](const CLI::App*, const CLI::Error& e) {
    const bool number = e.get_name() == "ConversionError";
    return powderlink::for_terminal(
        std::string("powderlink: command line; given: ") + e.what() +
        "; allowed: what --help tells; to do: " +
        (number ? "write numbers without a unit, whole or with a decimal point as the option asks"
                : "correct the line") +
        "\n");
  });
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& e) {
    return app.exit(e) == 0 ? 0 : kUsage;
  }
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  powderlink::silence_library_logs();
  try {
    return run(argc, argv);
  } catch (const std::exception& e) {
    // Names and cells of users may hold anything.
    std::fprintf(stderr, "powderlink: %s\n", powderlink::for_terminal(e.what()).c_str());
    return kFailed;
  }
}
