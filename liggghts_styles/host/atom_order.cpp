// SPDX-License-Identifier: GPL-3.0-or-later
#include "liggghts_styles/host/atom_order.h"

#include <algorithm>
#include <numeric>
#include <vector>

#include "atom.h"
#include "atom_vec.h"

namespace powderlink::host {

void set_atom_order(LAMMPS_NS::LAMMPS* lmp) {
  LAMMPS_NS::Atom* atom = lmp->atom;
  const int n = atom->nlocal;
  // The place behind the last atom takes one atom of each cycle of the permutation.
  if (n == atom->nmax) atom->avec->grow(0);
  const int* tag = atom->tag;
  std::vector<int> from(static_cast<std::size_t>(n));
  std::iota(from.begin(), from.end(), 0);
  std::sort(from.begin(), from.end(), [tag](int i, int j) { return tag[i] < tag[j]; });
  for (int first = 0; first < n; ++first) {
    if (from[first] == first) continue;
    atom->avec->copy(first, n, 0);
    int empty = first;
    while (from[empty] != first) {
      atom->avec->copy(from[empty], empty, 0);
      const int next = from[empty];
      from[empty] = empty;
      empty = next;
    }
    atom->avec->copy(n, empty, 0);
    from[empty] = empty;
  }
  if (atom->sortfreq > 0) atom->sort();
}

}  // namespace powderlink::host
