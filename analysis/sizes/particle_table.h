// SPDX-License-Identifier: GPL-3.0-or-later
/// \file particle_table.h
/// Tables of grains as ImageJ and Fiji save them ("Analyze Particles", "Measure"), and those of
/// `powderlink psd` itself (particles.csv), in any form of csv_table.h.
///
///   needed:    Area, and Perim. or Circ. (then P = sqrt(4 pi A/Circ.))
///   used:      AR or Round (= 1/AR), Feret
///   units:     pixels, unless name or row of units say otherwise (particle_columns.h)
///   the scale: argument, or a comment line `# pixel_size_um: 0.5`, or a column `pixel_size_um`
///
/// Rows that ImageJ's Summarize appends (Mean, SD, Min, Max) are left out, with a note.
/// Perim. and Circ. of ImageJ's own tables are freed of its bias where the pixel is known
/// (imagej_perimeter.h); what cannot be is refused, what is doubtful noted (table_doubts.h).
/// Case does not matter, nor does a dot at the end of a name. Errors are InvalidInput with file,
/// line and column; different pixel sizes in one set are refused, because what is too small to be
/// seen then differs from file to file.
/// Tests: tests/analysis/sizes/particle_table_test.cpp
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "analysis/sizes/particle.h"

namespace powderlink::analysis {

struct ParticleSet {
  std::vector<std::string> files;
  std::optional<double> pixel_size_um;  ///< empty: tables in um that do not say it
  std::vector<Particle> particles;
  std::vector<std::string> notes;            ///< what a reader of the result should know
  std::vector<std::string> perimeter_notes;  ///< ... of one that uses perimeters
  /// Of the printed areas, the largest of all tables; 0 for counts of pixels and for pictures. A diameter
  /// d is known to +-step/(pi d).
  double area_step_um2 = 0.0;
};

/// 1e-4 to 1000 um; `where` names option or file.
double require_pixel_size_um(double value, const std::string& where);

/// \param pixel_size_um  of tables that count pixels and do not say it; 1 for ImageJ tables of an
///                       image with a scale in um
ParticleSet read_particle_tables(const std::vector<std::filesystem::path>& files,
                                 const std::optional<double>& pixel_size_um);

}  // namespace powderlink::analysis
