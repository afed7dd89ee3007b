#!/usr/bin/env bash
# The bed of packed_bed on meshes from 4 d to 0.5 d per cell.
# run.sh [--short] [--ranks N] [--dem-ranks N] [--transport mpi|socket] [--out DIR]
set -euo pipefail
cd "$(dirname "$0")"
. ../../scripts/foam_case.sh
bed=$(realpath ../packed_bed)
. "$bed/ergun.sh"
foam_case_options "$@"

meshes=("4d:2 2 4" "2d:4 4 8" "1d:8 8 16" "0.5d:16 16 32")
drops=
for mesh in "${meshes[@]}"; do
  case_copy=case_${mesh%%:*} foam_case_copy "$bed"
  foam_case_set system/caseSettings cells "(${mesh#*:})"
  foam_case_run blockMesh
  foam_case_couple in.packed_bed
  drop=$(pressure_drop_Pa)
  drops+=" $drop"
  foam_case_result "pressure_drop_${mesh%%:*}" Pa "$drop" "$(ergun_Pa)" 0.03 \
    "Ergun 1952; cells of about ${mesh%%:*}"
done
spread=$(awk -v drops="$drops" 'BEGIN {
  n = split(drops, p, " "); low = high = p[1]
  for (i = 1; i <= n; i++) { if (p[i] < low) low = p[i]; if (p[i] > high) high = p[i] }
  printf "%.6f", (high - low)/high }')
foam_case_result spread 1 "$spread" 0 0.03 "the same bed: largest minus smallest drop, over the largest"
foam_case_write bed_mesh
