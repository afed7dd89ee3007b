// SPDX-License-Identifier: GPL-3.0-or-later
/// \file couple_bridge_options.h
/// The arguments of `fix couple/bridge`, parsed and checked.
///
///   fix ID group couple/bridge every N
///       [transport mpi|socket]      default mpi: both programs in one mpirun
///       [address A]                 unix:PATH or HOST:PORT, for socket
///       [rendezvous FILE]           default bridge.address when there is no address
///       [token T] [connect|listen]  default connect: the solver listens
///       [timeout S]                 of every wait, default 120 s
///       [case NAME]                 default: name of the current folder
///       [checkpoint FILE-PREFIX]    default post/restart.
///       [sizes like|any]            of LIGGGHTS's box and the mesh; like: within a factor of 100
/// Tests: tests/liggghts_styles/couple_bridge_options_test.cpp
#pragma once

#include <string>

namespace powderlink::host {

struct CoupleBridgeOptions {
  int every = 0;  ///< DEM steps between exchanges
  bool socket = false;
  std::string address;
  std::string rendezvous_file;
  std::string token;
  bool listens = false;
  double timeout_s = 120.0;
  std::string case_name;
  std::string checkpoint_prefix = "post/restart.";
  bool any_size = false;

  /// \param folder  name of the current folder
  /// Throws InvalidInput.
  static CoupleBridgeOptions parse(int narg, const char* const* arg, const std::string& folder);
};

}  // namespace powderlink::host
