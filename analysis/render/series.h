// SPDX-License-Identifier: GPL-3.0-or-later
/// \file series.h
/// Time series for ParaView: particles.pvd and plate.pvd with physical times, and the converted
/// states in vtk/. LIGGGHTS's own files are left as they are.
/// Tests: tests/analysis/render/series_test.cpp
#pragma once

#include <filesystem>
#include <functional>
#include <string>

#include "analysis/render/run_directory.h"

namespace powderlink::render {

struct SeriesFiles {
  std::filesystem::path particles_pvd, plate_pvd;
  std::size_t states = 0;
};

/// Called after every converted state.
using Progress = std::function<void(std::size_t done, std::size_t all)>;

/// Writes RUN/particles.pvd, RUN/plate.pvd, RUN/plate.vtp (plane plate) and RUN/vtk/.
SeriesFiles write_series(const RunDirectory& run, const std::string& fix = "kat",
                         const Progress& progress = {});

}  // namespace powderlink::render
