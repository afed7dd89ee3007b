// SPDX-License-Identifier: GPL-3.0-or-later
/// \file grain_files.h
/// Diameters of the grains before and after a drop, from tables of grains (sizes/particle_table.h)
/// or, with a reader that knows them, from micrographs (sizes/pictures/grain_source.h).
/// Both sets are read as one, so that different pixel sizes are refused between them too; shapes that
/// differ much between them are noted, as one of them then shows noise.
/// Tests: tests/analysis/program/kat_analyse_command_test.cpp, tests/analysis/sizes/kat_pictures_test.cpp
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "analysis/sizes/particle_table.h"

namespace powderlink::analysis {

struct GrainFiles {
  std::vector<std::string> before, after;  ///< names or patterns
  std::optional<double> pixel_size_um{};
  bool by_perimeter = false;  ///< d_P = 4 A/P instead of d_A = sqrt(4 A/pi)
};

struct GrainDiameters {
  std::vector<double> before_um, after_um;
  std::vector<std::string> before_files, after_files;
  std::optional<double> pixel_size_um;
  std::vector<std::string> notes;
  double digits_um2 = 0.0;  ///< a diameter d is known to +-digits_um2/d from the printed digits

  /// Area seen after over that before, if every file shows the same area.
  double ratio_of_files() const;
};

using ParticleReader = std::function<ParticleSet(const std::vector<std::filesystem::path>& files,
                                                 std::optional<double> pixel_size_um)>;

/// Tables only; refuses pictures, and says what makes tables of them.
ParticleSet read_tables_of_grains(const std::vector<std::filesystem::path>& files,
                                  std::optional<double> pixel_size_um);

/// Throws InvalidInput for files that cannot be read and for a file that is in both lists.
GrainDiameters read_grains(const GrainFiles& files,
                           const ParticleReader& reader = read_tables_of_grains);

}  // namespace powderlink::analysis
