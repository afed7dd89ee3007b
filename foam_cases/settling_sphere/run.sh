#!/usr/bin/env bash
# Spheres of steel that fall in argon: terminal velocities and the way there.
# run.sh [--short] [--ranks N] [--dem-ranks N] [--transport mpi|socket] [--out DIR]
set -euo pipefail
cd "$(dirname "$0")"
. ../../scripts/foam_case.sh
reference=$PWD/reference.awk
foam_case_options "$@"
foam_case_copy
foam_case_end 1.2 0.8 1e-5

foam_case_run blockMesh
foam_case_couple in.settling_sphere -var steps "$dem_steps"

# One line per sphere: diameter [um], velocity at the end, largest deviation from the equation of
# motion over the terminal velocity.
awk -f "$reference" post/particles_*.dump >spheres.txt
printed=(20:0.0752 45:0.3381 75:0.7748 105:1.2473)
for sphere in "${printed[@]}"; do
  read -r velocity deviation < <(awk -v d="${sphere%:*}" '$1 == d { print $2, $3 }' spheres.txt) || true
  foam_case_result "terminal_velocity_${sphere%:*}um" m/s "${velocity:-}" "${sphere#*:}" 0.002 \
    "Schiller-Naumann with buoyancy, argon 1.66 kg/m3 and 2.23e-5 Pa s, steel 7950 kg/m3"
  foam_case_result "transient_${sphere%:*}um" 1 "${deviation:-}" 0 0.005 \
    "equation of motion by Runge-Kutta; largest deviation over the terminal velocity"
done
foam_case_write settling_sphere
