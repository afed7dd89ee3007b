// SPDX-License-Identifier: GPL-3.0-or-later
/// \file commands.h
/// The subcommands of `powderlink`; one file each. Each adds itself to its parent and runs when it
/// is named on the command line. Errors are thrown as InvalidInput and printed by main.
#pragma once

namespace CLI {
class App;
}

namespace powderlink::analysis {

void add_kat_analyse_command(CLI::App& kat);
void add_kat_theory_command(CLI::App& kat);
void add_kat_run_command(CLI::App& kat);
void add_kat_device_command(CLI::App& kat);
void add_add_command(CLI::App& app);
void add_compare_command(CLI::App& app);
void add_contact_command(CLI::App& app);
void add_diagnose_command(CLI::App& app);
void add_effects_command(CLI::App& app);
void add_flow_command(CLI::App& app);
void add_psd_command(CLI::App& app);
void add_report_command(CLI::App& app);
void add_restart_command(CLI::App& app);

}  // namespace powderlink::analysis
