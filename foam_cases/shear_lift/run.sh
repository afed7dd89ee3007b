#!/usr/bin/env bash
# A sphere in linear shear: lift of Saffman and Mei, and the way it takes.
# run.sh [--short] [--ranks N] [--dem-ranks N] [--transport mpi|socket] [--out DIR]
set -euo pipefail
cd "$(dirname "$0")"
. ../../scripts/foam_case.sh
reference=$PWD/reference.awk
decompose_axis=x
foam_case_options "$@"
foam_case_copy
foam_case_end 0.05 0.02 1e-5

foam_case_run blockMesh
foam_case_run setExprFields
foam_case_couple in.shear_lift -var steps "$dem_steps"

# Each line: name, unit, value, reference.
while read -r name unit value expected; do
  case $name in
    lift | drag_coefficient) tolerance=1e-4 ;;
    *) tolerance=0.005 ;;
  esac
  foam_case_result "$name" "$unit" "$value" "$expected" "$tolerance" \
    "Saffman 1965, Mei 1992, Schiller-Naumann; equation of motion by Runge-Kutta"
done < <(awk -v end_s="$end_s" -v exchange_s=1e-4 -f "$reference" post/particles_*.dump post/states.dump)
foam_case_write shear_lift
