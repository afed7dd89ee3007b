// SPDX-License-Identifier: GPL-3.0-or-later
/// \file last_error.h
/// What was said when this process began to end by an error: of ours (host/stop_all.h) or of LIGGGHTS's
/// own (plugin/liggghts_errors.cpp). Both leave by MPI_Finalize() or MPI_Abort(), which know no reason.
#pragma once

#include <string>

namespace powderlink::host {

void keep_error(const std::string& text);
/// On this rank; empty without an error.
const std::string& kept_error();

}  // namespace powderlink::host
