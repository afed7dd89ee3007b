#!/usr/bin/env bash
# A settled bed below and above minimum fluidisation.
# run.sh [--short] [--ranks N] [--dem-ranks N] [--transport mpi|socket] [--out DIR]
set -euo pipefail
cd "$(dirname "$0")"
. ../../scripts/foam_case.sh
bed=$PWD/bed.awk settled=$PWD/settled.awk
foam_case_options "$@"
end_s=0.5
if [[ $short == yes ]]; then end_s=0.25; fi
steps=$(awk -v t="$end_s" 'BEGIN { printf "%d", t/1e-5 + 0.5 }')

# The second half of a run is its result.
run_bed() {  # folder, superficial velocity; sets drop [Pa], height [m] of the spheres' centre of mass
  local start=$out/fixed/post/restart.settled
  case_copy=$1 foam_case_copy "$case_folder"
  foam_case_set system/caseSettings endTime "$end_s"
  foam_case_set system/caseSettings superficialVelocity "$2"
  foam_case_run blockMesh
  if [[ $1 == fixed ]]; then
    foam_case_run "$foam_case_bin/liggghts-powderlink" -in in.settle
  else
    cp "$start" post/
  fi
  foam_case_couple in.fluidisation -var steps "$steps"
  drop=$(awk -v from="$end_s" '!/^#/ && $1 > from/2 { sum += $2; n++ } END { printf "%.4f", 10*sum/n }' \
    postProcessing/inletPressure/0/surfaceFieldValue.dat)
  height=$(awk -v from="$end_s" '!/^#/ && $1 > from/2 { sum += $2; n++ } END { printf "%.9f", sum/n }' \
    post/height.txt)
}
case_folder=$PWD
foam_case_need liggghts-powderlink

run_bed fixed 0.010
fixed_height=$height fixed_drop=$drop
read -r least most < <(awk -f "$settled" "post/particles_$steps.dump") || true
echo "drop of the settled bed at 0.010 m/s: $fixed_drop Pa; its spheres by Gidaspow: $least to $most Pa"
settled_height=$(awk '!/^#/ { printf "%.9f", $2; exit }' post/height.txt)
run_bed fluidised 0.020

# weight, expansion at 0.020 m/s
read -r weight expansion < <(awk -v height="$settled_height" -f "$bed")
foam_case_result fixed_height 1 "$(awk -v a="$fixed_height" -v b="$settled_height" 'BEGIN { printf "%.6f", a/b }')" \
  1 0.002 "a fixed bed does not expand; height of the centre of mass over the settled one"
foam_case_result fixed_drop Pa "$fixed_drop" "$(awk -v a="$least" -v b="$most" 'BEGIN { printf "%.4f", (a + b)/2 }')" \
  0.02 "Gidaspow's drag of the spheres where they lie: mean of the bounds of perfect and no cross-flow, 0.010 m/s"
foam_case_result fluidised_drop Pa "$drop" "$weight" 0.03 \
  "weight less buoyancy of the spheres per area, 0.020 m/s"
foam_case_result fluidised_height 1 "$(awk -v a="$height" -v b="$settled_height" 'BEGIN { printf "%.6f", a/b }')" \
  "$expansion" 0.03 "even expansion to where Gidaspow's drag carries the spheres"
foam_case_write fluidisation
