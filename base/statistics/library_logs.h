// SPDX-License-Identifier: GPL-3.0-or-later
/// \file library_logs.h
/// Ceres writes a log of its own to the terminal, as when a law is fitted to what it cannot fit; what
/// matters of it is in the program's words.
#pragma once

namespace powderlink {

/// Below an abort; once, at the start.
void silence_library_logs();

}  // namespace powderlink
