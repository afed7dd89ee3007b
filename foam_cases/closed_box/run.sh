#!/usr/bin/env bash
# Momentum of gas and particles in a periodic box.
# run.sh [--short] [--ranks N] [--dem-ranks N] [--transport mpi|socket] [--out DIR]
set -euo pipefail
cd "$(dirname "$0")"
. ../../scripts/foam_case.sh
momentum=$PWD/momentum.awk
foam_case_options "$@"

# In water the spheres take half their volume of it along: added mass, 1/16 of their own.
for fluid in argon water; do
  case_copy=case_$fluid foam_case_copy
  foam_case_end 4e-3 1e-3 5e-7
  rho=1.66
  if [[ $fluid == water ]]; then
    rho=998.2
    foam_case_set constant/transportProperties rho "$rho"
    foam_case_set constant/transportProperties nu 1.004e-6
    foam_case_set constant/couplingProperties particleMomentum/forces '(schiller_naumann virtual_mass)'
  fi
  foam_case_run blockMesh
  foam_case_couple in.closed_box -var steps "$dem_steps"

  while read -r name value; do
    foam_case_result "${name}_$fluid" 1 "$value" 0 1e-3 \
      "fluid plus particles gain the impulse of gravity; over what was exchanged"
  done < <(awk -v rho=$rho -f "$momentum" postProcessing/gasMomentum/0/volFieldValue.dat post/momentum.txt)
  foam_case_closure "exchange_closure_$fluid"
done
foam_case_write closed_box
