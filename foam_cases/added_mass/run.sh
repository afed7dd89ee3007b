#!/usr/bin/env bash
# Spheres in water that a pressure gradient accelerates: added mass and the water's acceleration.
# run.sh [--short] [--ranks N] [--dem-ranks N] [--transport mpi|socket] [--out DIR]
set -euo pipefail
cd "$(dirname "$0")"
. ../../scripts/foam_case.sh
decompose_axis=x
foam_case_options "$@"
foam_case_copy
foam_case_end 0.1 0.05 1e-5

foam_case_run blockMesh
foam_case_couple in.added_mass -var steps "$dem_steps"

# Acceleration of each sphere between 20 ms and the end. Not from 0: the first interval begins with
# water that has not been accelerated yet.
accelerations=$(awk '
  /^ITEM: TIMESTEP/ { getline; time = $1*1e-5; rows = 0; next }
  /^ITEM: ATOMS/ { rows = 1; next }
  /^ITEM/ { rows = 0 }
  rows && time > 0.0199 && time < 0.0201 { early[$1] = $6; early_s = time }
  rows && time > late_s { late_s = time }
  rows { last[$1, time] = $6 }
  END { for (id = 1; id <= 3; id++) printf "%.10g\n", (last[id, late_s] - early[id])/(late_s - early_s) }
' post/particles_*.dump)
spheres=(bubble:1.2 neutral:998.2 steel:7950)
while read -r value; do
  name=${spheres[0]%:*} density=${spheres[0]#*:}
  spheres=("${spheres[@]:1}")
  foam_case_result "acceleration_$name" m/s2 "$value" \
    "$(awk -v r="$density" 'BEGIN { printf "%.10g", 10*3*998.2/(998.2 + 2*r) }')" 1e-5 \
    "sphere of density rho_p in an ideal fluid: 3 rho/(rho + 2 rho_p) times the fluid's acceleration"
done <<<"$accelerations"
foam_case_closure exchange_closure
foam_case_write added_mass
