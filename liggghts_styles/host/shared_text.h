// SPDX-License-Identifier: GPL-3.0-or-later
/// \file shared_text.h
/// What the first rank says, on all ranks.
#pragma once

#include <string>

#include <mpi.h>

namespace powderlink::host {

/// Collective. \param text  that of rank 0 counts
inline std::string text_of_first_rank(MPI_Comm world, const std::string& text) {
  int size = static_cast<int>(text.size());
  MPI_Bcast(&size, 1, MPI_INT, 0, world);
  std::string shared = text;
  shared.resize(static_cast<std::size_t>(size));
  MPI_Bcast(shared.data(), size, MPI_CHAR, 0, world);
  return shared;
}

}  // namespace powderlink::host
