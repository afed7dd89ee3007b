#!/usr/bin/env bash
# Pressure drop of a fixed bed against Ergun.
# run.sh [--short] [--ranks N] [--dem-ranks N] [--transport mpi|socket] [--out DIR]
set -euo pipefail
cd "$(dirname "$0")"
. ../../scripts/foam_case.sh
. ergun.sh
foam_case_options "$@"
foam_case_copy

foam_case_run blockMesh
foam_case_couple in.packed_bed

foam_case_result pressure_drop Pa "$(pressure_drop_Pa)" "$(ergun_Pa)" 0.01 \
  "Ergun 1952: 22.99 Pa by its viscous term, 23.00 Pa with inertia"
foam_case_result fluid_fraction 1 "$(tail -n 1 postProcessing/fluidFraction/0/volFieldValue.dat |
  awk '{ printf "%.9f", $2 }')" 0.4513 1e-6 "volume of the spheres over that of the box"
foam_case_write packed_bed
