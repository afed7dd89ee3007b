// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/render/flow_series.h"

#include <fmt/format.h>
#include <vtkPolyData.h>

#include <vector>

#include "analysis/flow/run/particle_clock.h"
#include "analysis/render/files.h"
#include "analysis/render/flow_case.h"
#include "analysis/render/pvd.h"
#include "base/files/write_file.h"

namespace powderlink::render {

namespace fs = std::filesystem;

FlowSeriesFiles write_flow_series(const fs::path& case_folder, std::optional<double> time_step_s,
                                  const Progress& progress) {
  const std::vector<fs::path> dumps = analysis::list_dumps(case_folder);
  analysis::ParticleClock clock(case_folder, time_step_s);
  std::vector<PvdEntry> entries;
  StagedFolder folder(case_folder / "vtk");
  std::size_t done = 0;
  for (const fs::path& dump : dumps) {
    analysis::read_dump(dump, [&](const analysis::DumpState& state) {
      const std::string name = fmt::format("particles_{}.vtp", state.step);
      write_vtp(folder.path() / name, particles_of(state));
      entries.push_back({clock.gas_time_s(state), "vtk/" + name});
    });
    if (progress) progress(++done, dumps.size());
  }
  folder.publish();
  FlowSeriesFiles written{case_folder / "particles.pvd", make_foam_file(case_folder),
                          entries.size()};
  write_file(written.particles_pvd, pvd_text(entries));
  return written;
}

}  // namespace powderlink::render
