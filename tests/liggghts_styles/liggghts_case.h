// SPDX-License-Identifier: GPL-3.0-or-later
/// \file liggghts_case.h
/// Runs small cases through the real LIGGGHTS with powderlink's styles and reads what came out.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace powderlink::testing {

struct Sphere {
  int type = 1;
  double diameter = 46e-6;
  double density = 7980.0;
  double x[3] = {0, 0, 0};
  double v[3] = {0, 0, 0};
  double omega[3] = {0, 0, 0};
};

struct Outcome {
  int status = 0;      ///< exit status of the program
  std::string output;  ///< screen and error output
  std::filesystem::path folder;
  std::vector<Sphere> last;  ///< ordered by id, of the last dump (only x, v, omega are filled)
};

/// A folder of its own for each case, removed and made anew.
class LiggghtsCase {
 public:
  explicit LiggghtsCase(const std::string& name);
  const std::filesystem::path& folder() const { return folder_; }

  void write(const std::string& file, const std::string& content) const;
  /// LIGGGHTS data file of the spheres; the box encloses `half` around the origin.
  void write_spheres(const std::string& file, const std::vector<Sphere>& spheres,
                     double half) const;
  /// Square plate z = 0 of 2 n^2 triangles, from -half to half.
  void write_plate(const std::string& file, double half, int n) const;

  enum class Program { launcher, preload, stock };
  /// Writes the script, runs it on the given number of ranks, reads `last.dump` if there is one.
  Outcome run(const std::string& script, int ranks = 1, Program program = Program::launcher,
              const std::string& options = "") const;
  struct Coupled {
    std::string solver = {};  ///< arguments of fake_solver beside case= and socket=
    int dem_ranks = 1;
    int solver_ranks = 1;
    bool socket = false;      ///< two jobs instead of one
    std::string before = {};  ///< a shell command that changes limits of the LIGGGHTS side
    Program program = Program::launcher;
    std::string options = {};  ///< further ones of LIGGGHTS
    int solver_runs = 1;       ///< with `socket`: one solver after the other
  };
  /// Writes the script and runs it with the fake solver. With `socket` the status is that of LIGGGHTS,
  /// or 99 when only the solver failed.
  Outcome couple(const std::string& script, const Coupled& how) const;
  /// What `liggghts-powderlink -h` prints.
  Outcome help() const;

 private:
  Outcome execute(const std::string& command) const;
  std::filesystem::path folder_;
};

/// Everything from `units` to `pair_coeff` of a case with two types: powder (1) and plate (2).
struct Setting {
  std::string model = "jkr";
  std::string model_options = " tangential off";
  double youngs_modulus[2] = {2.11e11, 3.0e9};  // 316L, UPVC
  double poissons_ratio[2] = {0.3, 0.3};
  double restitution = 1.0;
  double friction = 0.5;
  double rolling_friction = 0.1;
  double work_of_adhesion = 17.16;
  double work_of_adhesion_same = 0.0;  ///< of like types
  double skin = 5e-6;
  double time_step = 2.4486e-9;
};
std::string header(const Setting& s, const std::string& data_file);
/// `fix plate all wall/gran` on z = 0: primitive, or mesh from plate.stl.
std::string primitive_plate(const Setting& s);
std::string mesh_plate(const Setting& s);
/// Integration, one dump at the end into last.dump, and the run.
std::string run_lines(long steps);
std::string dump_line(long every);

}  // namespace powderlink::testing
