// SPDX-License-Identifier: GPL-3.0-or-later
/// \file liggghts_errors.h
/// What LIGGGHTS says when it ends by an error of its own. Its Error class prints the text and leaves by
/// MPI_Finalize() or MPI_Abort(), which know no reason.
#pragma once

#include <string>

namespace powderlink::plugin {

/// Text and place of the last error on this rank; without one, where to look.
std::string last_liggghts_error();

}  // namespace powderlink::plugin
