// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/render/series.h"

#include <vtkPolyData.h>

#include <string>
#include <vector>

#include "analysis/render/files.h"
#include "analysis/render/particle_frame.h"
#include "analysis/render/plate.h"
#include "analysis/render/pvd.h"
#include "base/files/write_file.h"

namespace powderlink::render {
SeriesFiles write_series(const RunDirectory& run, const std::string& fix,
                         const Progress& progress) {
  std::vector<PvdEntry> particles, plate;
  vtkSmartPointer<vtkPolyData> plane;
  StagedFolder folder(run.path / "vtk");
  std::size_t done = 0;
  for (const DumpFile& dump : run.particles) {
    const double time_s = run.time_s(dump.step);
    const auto state = read_particles(dump.path, fix);
    if (run.plate.empty()) {
      if (plane == nullptr) plane = plate_above(state);
      plate.push_back({time_s, "plate.vtp"});
    }
    const std::string name = dump.path.filename().string();
    write_vtp(folder.path() / name, state);
    particles.push_back({time_s, "vtk/" + name});
    if (progress) progress(++done, run.particles.size() + run.plate.size());
  }
  for (const DumpFile& dump : run.plate) {
    const std::string name = dump.path.stem().string() + ".vtp";
    write_vtp(folder.path() / name, read_plate(dump.path));
    plate.push_back({run.time_s(dump.step), "vtk/" + name});
    if (progress) progress(++done, run.particles.size() + run.plate.size());
  }
  folder.publish();

  SeriesFiles written{run.path / "particles.pvd", run.path / "plate.pvd", particles.size()};
  if (plane != nullptr) write_vtp(run.path / "plate.vtp", plane);
  write_file(written.particles_pvd, pvd_text(particles));
  write_file(written.plate_pvd, pvd_text(plate));
  return written;
}

}  // namespace powderlink::render
