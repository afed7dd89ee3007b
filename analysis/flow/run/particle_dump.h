// SPDX-License-Identifier: GPL-3.0-or-later
/// \file particle_dump.h
/// LIGGGHTS's text dumps (dump custom), one state in memory at a time. Columns are found by name:
/// needed x y z vx vy vz radius mass, used when there id. A file may hold one state or many.
/// Units SI. A file that breaks off, rows without a column or numbers that are none are refused.
/// Tests: tests/analysis/flow/flow_dump_test.cpp
#pragma once

#include <array>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace powderlink::analysis {

struct DumpParticle {
  long id = 0;  ///< 0 when the dump has no column id
  double x_m = 0.0, y_m = 0.0, z_m = 0.0;
  double vx_m_s = 0.0, vy_m_s = 0.0, vz_m_s = 0.0;
  double radius_m = 0.0, mass_kg = 0.0;
};

struct DumpState {
  long step = 0;
  std::optional<double> time_s;  ///< when the dump itself says it (ITEM: TIME)
  std::vector<DumpParticle> particles;
  std::array<double, 3> box_low_m{}, box_high_m{};
  std::array<bool, 3> periodic{};
};

/// CASE/post/particles_*.dump by the number in the name, without anything that does not fit.
/// Throws when there is none.
std::vector<std::filesystem::path> list_dumps(const std::filesystem::path& case_folder);

/// The step in the name particles_<step>.dump; empty when there is no number.
std::optional<long> step_of_name(const std::filesystem::path& dump);

/// Hands each state of a file to `use`; the state is reused for the next one.
void read_dump(const std::filesystem::path& dump, const std::function<void(const DumpState&)>& use);

/// Only the first state of a file; the rest is not read.
DumpState read_first_state(const std::filesystem::path& dump);

/// The last state of a file.
DumpState read_last_state(const std::filesystem::path& dump);

}  // namespace powderlink::analysis
