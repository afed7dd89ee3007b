// SPDX-License-Identifier: GPL-3.0-or-later
/// \file run_tables.h
/// Tables over time that the programs of a coupled run write: OpenFOAM's function objects, the counts
/// of LIGGGHTS's fix print, the means of its fix ave/spatial. A run that went on after a stop has a
/// file for each of its parts; at equal times the later part wins. A last line that breaks off is left
/// out; any other row with another number of values is refused.
/// Tests: tests/analysis/flow/flow_observables_test.cpp
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace powderlink::analysis {

/// Rows by time [s]; the head is the first file's.
struct RunTable {
  std::vector<std::string> head;  ///< lines that begin with #
  std::map<double, std::vector<double>> rows;

  /// Mean of column i over the rows in (from, to]; empty without any.
  std::optional<double> mean(std::size_t column, double from_s, double to_s) const;
  /// Value of `# name : value`, as OpenFOAM writes heads.
  std::optional<double> head_number(const std::string& name) const;
};

/// Folders of what a function object wrote, by the start time of each part of the run.
std::map<double, std::filesystem::path> start_folders(const std::filesystem::path& set);

/// postProcessing/FUNCTION/<start>/STEM[_<time>].dat; empty when it is not there. Vectors and tensors
/// are so many values; the first column is the time and not among them.
RunTable read_function_object(const std::filesystem::path& case_folder, const std::string& function,
                              const std::string& stem);

/// post/particle_count.csv, by column: time_s and what else there is. Empty when it is not there.
std::map<std::string, std::vector<double>> read_counts(const std::filesystem::path& case_folder);

/// One output of fix ave/spatial: sums over the particles of each bin, means over the interval.
struct BinnedForces {
  long step = 0;
  std::vector<double> centre_m, wall_N, fluid_N;
};

/// post/powder_forces_<first step>.txt with columns Coord, Ncount, v_wallForce and v_fluidForce.
std::vector<BinnedForces> read_powder_forces(const std::filesystem::path& case_folder);

}  // namespace powderlink::analysis
