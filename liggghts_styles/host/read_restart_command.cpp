// SPDX-License-Identifier: GPL-3.0-or-later
#include "liggghts_styles/host/read_restart_command.h"

#include <algorithm>
#include <exception>
#include <filesystem>
#include <string>

#include <mpi.h>

#include "lammps.h"
#include "read_restart.h"

#include "liggghts_styles/host/restart_file.h"
#include "liggghts_styles/host/shared_text.h"
#include "liggghts_styles/host/stop_all.h"

namespace powderlink::host {

using namespace LAMMPS_NS;
namespace fs = std::filesystem;

namespace {

/// The name with the step of the latest file in the place of `*`, as LIGGGHTS takes it; `%` stands for
/// `base` while that is looked for. The name itself when there is none.
std::string latest(const std::string& name) {
  const fs::path path(name);
  const std::string pattern = path.filename().string();
  const auto star = pattern.find('*');
  if (star == std::string::npos) return name;
  const auto with_base = [](std::string part) {
    const auto percent = part.find('%');
    return percent == std::string::npos ? part : part.replace(percent, 1, "base");
  };
  const std::string begin = with_base(pattern.substr(0, star));
  const std::string end = with_base(pattern.substr(star + 1));
  long long most = -1;
  std::error_code problem;
  const fs::path folder = path.has_parent_path() ? path.parent_path() : fs::path(".");
  for (const auto& entry : fs::directory_iterator(folder, problem)) {
    const std::string file = entry.path().filename().string();
    if (file.size() <= begin.size() + end.size() || file.rfind(begin, 0) != 0) continue;
    if (file.compare(file.size() - end.size(), end.size(), end) != 0) continue;
    const std::string step = file.substr(begin.size(), file.size() - begin.size() - end.size());
    constexpr std::size_t most_digits = 18;
    if (step.size() > most_digits || step.find_first_not_of("0123456789") != std::string::npos) {
      continue;
    }
    most = std::max(most, std::stoll(step));
  }
  if (most < 0) return name;
  std::string found = name;
  return found.replace(found.rfind('*'), 1, std::to_string(most));
}

std::string why_not(const std::string& file) {
  try {
    if (file.find('*') != std::string::npos) return "no file of that name with a step";
    return why_not_whole_restart(file);
  } catch (const std::exception& problem) {
    return file + " cannot be read: " + problem.what();
  }
}

}  // namespace

void read_restart_command(LAMMPS* lmp, int narg, char** arg) {
  if (narg != 1) {
    ReadRestart(lmp).command(narg, arg);
    return;
  }
  int rank = 0;
  MPI_Comm_rank(lmp->world, &rank);
  std::string file = text_of_first_rank(lmp->world, rank == 0 ? latest(arg[0]) : "");
  const std::string wrong = text_of_first_rank(lmp->world, rank == 0 ? why_not(file) : "");
  if (!wrong.empty()) {
    stop_all(
        lmp, FLERR, nullptr,
        std::string("read_restart ") + arg[0] + "; given: " + wrong +
            "; allowed: a restart file of LIGGGHTS that is there as a whole; "
            "to do: take an earlier one; "
            "of a coupled case `powderlink restart CASE --prepare` finds the last complete pair "
            "and links it as post/restart.latest");
  }
  char* found = file.data();
  ReadRestart(lmp).command(1, &found);
}

}  // namespace powderlink::host
