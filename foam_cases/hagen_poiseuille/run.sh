#!/usr/bin/env bash
# Pressure gradient of developed pipe flow against Hagen-Poiseuille.
# run.sh [--short] [--ranks N] [--out DIR]
set -euo pipefail
cd "$(dirname "$0")"
. ../../scripts/foam_case.sh
foam_case_options "$@"
foam_case_copy

foam_case_run blockMesh
foam_case_solve

# Kinematic pressure times the density of argon; least-squares slope over the probes.
density_kg_m3=1.6355
slope=$(awk -v density="$density_kg_m3" '
  /^# Probe/ { gsub(/[()]/, ""); z[n++] = $NF }
  !/^#/ { for (i = 0; i < n; i++) p[i] = density*$(i + 2) }
  END {
    for (i = 0; i < n; i++) { mz += z[i]/n; mp += p[i]/n }
    for (i = 0; i < n; i++) { zz += (z[i] - mz)^2; zp += (z[i] - mz)*(p[i] - mp) }
    printf "%.3f", -zp/zz
  }' postProcessing/axis/0/p)
# The last probe's velocity along the pipe: ( x y z ) is the last triple of the last line.
axis=$(awk 'END { gsub(/[()]/, ""); printf "%.4f", $NF }' postProcessing/axis/0/U)

foam_case_result pressure_gradient Pa/m "$slope" 4633 0.005 \
  "Hagen-Poiseuille: 32 mu U/D^2, argon 2.2622e-5 Pa s, 10 m/s, 1.25 mm"
foam_case_result velocity_on_axis m/s "$axis" 20 0.025 "Hagen-Poiseuille: twice the mean"
foam_case_write hagen_poiseuille
