// SPDX-License-Identifier: GPL-3.0-or-later
#include "liggghts_styles/host/checkpoint_file.h"

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <vector>

#include <mpi.h>
#include <unistd.h>

#include "atom.h"
#include "atom_vec.h"
#include "comm.h"
#include "domain.h"
#include "fix.h"
#include "modify.h"
#include "neighbor.h"
#include "write_restart.h"

#include "liggghts_styles/host/atom_order.h"
#include "liggghts_styles/host/shared_text.h"

namespace powderlink::host {

namespace {

namespace fs = std::filesystem;

std::string problem(const std::string& file, const std::string& given) {
  return "checkpoint " + file + "; given: " + given +
         "; allowed: a folder that can be written to, on a disk with room; "
         "to do: make room or choose another place with the keyword checkpoint; "
         "earlier checkpoints are whole";
}

/// Rank 0: empty, or why the folder does not take the file.
std::string prepare(const std::string& file, const std::string& part) {
  std::error_code error;
  const fs::path folder = fs::path(file).parent_path();
  if (!folder.empty()) fs::create_directories(folder, error);
  std::FILE* trial = std::fopen(part.c_str(), "wb");
  if (trial == nullptr) return problem(file, std::strerror(errno));
  std::fclose(trial);
  return {};
}

/// Rank 0: whether the file ends with the blocks of all ranks: an int, then so many doubles.
bool whole(const std::string& part, const std::vector<int>& doubles) {
  std::ifstream in(part, std::ios::binary | std::ios::ate);
  std::streamoff at = in.tellg();
  for (const int count : doubles) {
    at -=
        static_cast<std::streamoff>(sizeof(int) + sizeof(double) * static_cast<std::size_t>(count));
  }
  for (const int count : doubles) {
    if (at < 0) return false;
    int there = -1;
    in.seekg(at);
    in.read(reinterpret_cast<char*>(&there), sizeof there);
    if (!in || there != count) return false;
    at +=
        static_cast<std::streamoff>(sizeof(int) + sizeof(double) * static_cast<std::size_t>(count));
  }
  return true;
}

bool on_disk(const std::string& part) {
  std::FILE* file = std::fopen(part.c_str(), "rb+");
  if (file == nullptr) return false;
  const bool done = fsync(fileno(file)) == 0;
  return std::fclose(file) == 0 && done;
}

/// Rank 0: the written file gets its name, or goes.
std::string accept(const std::string& file, const std::string& part,
                   const std::vector<int>& doubles) {
  std::error_code error;
  if (!whole(part, doubles) || !on_disk(part)) {
    fs::remove(part, error);
    return problem(file, "the disk did not take the whole file");
  }
  fs::rename(part, file, error);
  return error ? problem(file, error.message()) : std::string();
}

}  // namespace

void bring_atoms_home(LAMMPS_NS::LAMMPS* lmp) {
  lmp->modify->pre_exchange();  // contact histories go to their atoms
  lmp->domain->pbc();
  lmp->domain->reset_box();
  lmp->comm->setup();
  if (lmp->neighbor->style != 0) lmp->neighbor->setup_bins();
  lmp->comm->exchange();
  set_atom_order(lmp);
  lmp->comm->borders();
  lmp->modify->pre_neighbor();
  lmp->neighbor->build();
  // Lists of meshes name atoms by their place, which has changed. LIGGGHTS makes them anew when forces
  // are due; fix massflow/mesh reads them before.
  for (int i = 0; i < lmp->modify->nfix; ++i) {
    LAMMPS_NS::Fix* fix = lmp->modify->fix[i];
    const std::string style = fix->style;
    if (style == "neighlist/mesh" || style == "contacthistory/mesh") fix->pre_force(0);
  }
}

std::string write_checkpoint(LAMMPS_NS::LAMMPS* lmp, const std::string& file) {
  std::string part = file + ".part";
  int rank = 0, ranks = 1;
  MPI_Comm_rank(lmp->world, &rank);
  MPI_Comm_size(lmp->world, &ranks);
  std::string wrong = text_of_first_rank(lmp->world, rank == 0 ? prepare(file, part) : "");
  if (!wrong.empty()) return wrong;

  LAMMPS_NS::WriteRestart(lmp).write(part.data());

  const int mine = lmp->atom->avec->size_restart();
  std::vector<int> doubles(static_cast<std::size_t>(ranks));
  MPI_Gather(&mine, 1, MPI_INT, doubles.data(), 1, MPI_INT, 0, lmp->world);
  return text_of_first_rank(lmp->world, rank == 0 ? accept(file, part, doubles) : "");
}

}  // namespace powderlink::host
