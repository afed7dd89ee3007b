#!/usr/bin/env bash
# Momentum of gas and particles in a periodic box.
# run.sh [--short] [--ranks N] [--dem-ranks N] [--transport mpi|socket] [--out DIR]
set -euo pipefail
cd "$(dirname "$0")"
. ../../scripts/foam_case.sh
momentum=$PWD/momentum.awk
foam_case_options "$@"
foam_case_copy
end_s=4e-3
if [[ $short == yes ]]; then end_s=2e-3; fi
sed -i "s/^endTime .*/endTime     $end_s;/" system/caseSettings

foam_case_run blockMesh
foam_case_couple in.closed_box -var steps "$(awk -v t="$end_s" 'BEGIN { printf "%d", t/5e-7 + 0.5 }')"

while read -r name value; do
  foam_case_result "$name" 1 "$value" 0 1e-3 "gas plus particles gain the impulse of gravity; over what was exchanged"
done < <(awk -f "$momentum" postProcessing/gasMomentum/0/volFieldValue.dat post/momentum.txt)
closure=$(awk '/^momentum \[N s\]:/ { n++; if ($NF > worst) worst = $NF } END { if (n) printf "%.3e", worst }' \
  log.powderFoam)
foam_case_result exchange_closure 1 "$closure" 0 1e-10 \
  "powderFoam's own sum after each exchange: fluid, particles and what is open, over what was exchanged"
foam_case_write closed_box
