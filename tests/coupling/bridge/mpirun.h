// SPDX-License-Identifier: GPL-3.0-or-later
/// \file mpirun.h
/// Runs two programs in one mpirun and keeps what they said. BRIDGE_MPIRUN is the launcher.
#pragma once

#include <sys/wait.h>

#include <array>
#include <chrono>
#include <cstdio>
#include <string>

namespace powderlink::test {

struct Outcome {
  int status = -1;
  double wall_s = 0.0;
  std::string output;

  bool says(const std::string& words) const { return output.find(words) != std::string::npos; }
};

inline Outcome shell(const std::string& command) {
  Outcome run;
  const auto start = std::chrono::steady_clock::now();
  FILE* pipe = popen((command + " 2>&1").c_str(), "r");
  if (!pipe) return run;
  std::array<char, 4096> part{};
  while (fgets(part.data(), static_cast<int>(part.size()), pipe)) run.output += part.data();
  const int status = pclose(pipe);
  run.status = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  run.wall_s = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return run;
}

/// One program of the line: "-np RANKS PROGRAM ARGUMENTS".
inline std::string ranks_of(int ranks, const std::string& program, const std::string& arguments) {
  return "-np " + std::to_string(ranks) + " " + program + " " + arguments;
}

inline Outcome mpirun(const std::string& programs) {
  return shell("OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1 timeout 50 " BRIDGE_MPIRUN
               " --oversubscribe --bind-to none --mca mpi_yield_when_idle 1 " +
               programs);
}

}  // namespace powderlink::test
