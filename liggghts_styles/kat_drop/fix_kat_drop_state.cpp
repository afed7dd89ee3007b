// SPDX-License-Identifier: GPL-3.0-or-later
/// The per-grain state of fix kat/drop: growth, migration between ranks, restart.
#include <algorithm>
#include <cstring>

#include "liggghts_styles/host/liggghts_headers.h"
#include "liggghts_styles/kat_drop/fix_kat_drop.h"

namespace powderlink::host {

using namespace LAMMPS_NS;

void FixKatDrop::grow_arrays(int nmax) {
  memory->grow(array_atom, nmax, kColumns, "kat/drop:state");
}

void FixKatDrop::copy_arrays(int i, int j, int /*delflag*/) {
  std::copy(array_atom[i], array_atom[i] + kColumns, array_atom[j]);
}

void FixKatDrop::set_arrays(int i) {
  std::fill(array_atom[i], array_atom[i] + kColumns, 0.0);
  array_atom[i][kKineticAtImpact] = -1.0;
}

int FixKatDrop::pack_exchange(int i, double* buf) {
  std::copy(array_atom[i], array_atom[i] + kColumns, buf);
  return kColumns;
}

int FixKatDrop::unpack_exchange(int nlocal, double* buf) {
  std::copy(buf, buf + kColumns, array_atom[nlocal]);
  return kColumns;
}

void FixKatDrop::write_restart(FILE* file) {
  const double list[] = {static_cast<double>(phase_),
                         static_cast<double>(start_step_),
                         static_cast<double>(impact_step_),
                         plate_position_,
                         plate_half_speed_,
                         settle_limit_s_,
                         watch_s_,
                         taking_part_};
  if (comm->me != 0) return;
  const int size = sizeof(list);
  fwrite(&size, sizeof(int), 1, file);
  fwrite(list, sizeof(list), 1, file);
}

void FixKatDrop::restart(char* buf) {
  double list[8];
  std::memcpy(list, buf, sizeof(list));
  phase_ = static_cast<Phase>(static_cast<int>(list[0]));
  start_step_ = static_cast<bigint>(list[1]);
  impact_step_ = static_cast<bigint>(list[2]);
  plate_position_ = list[3];
  plate_half_speed_ = list[4];
  settle_limit_s_ = list[5];
  watch_s_ = list[6];
  taking_part_ = list[7];
  restarted_ = placed_ = true;
}

int FixKatDrop::pack_restart(int i, double* buf) {
  buf[0] = kColumns + 1;
  std::copy(array_atom[i], array_atom[i] + kColumns, buf + 1);
  return kColumns + 1;
}

void FixKatDrop::unpack_restart(int nlocal, int nth) {
  double** extra = atom->extra;
  int m = 0;
  for (int i = 0; i < nth; ++i) m += static_cast<int>(extra[nlocal][m]);
  std::copy(extra[nlocal] + m + 1, extra[nlocal] + m + 1 + kColumns, array_atom[nlocal]);
}

int FixKatDrop::size_restart(int /*nlocal*/) { return kColumns + 1; }

int FixKatDrop::maxsize_restart() { return kColumns + 1; }

double FixKatDrop::memory_usage() {
  return static_cast<double>(atom->nmax) * kColumns * sizeof(double);
}

}  // namespace powderlink::host
