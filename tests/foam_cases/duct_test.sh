#!/usr/bin/env bash
# duct_test.sh REPOSITORY BIN WORK: the case of docs/first_coupled_job.md, whose grains settle for 3 ms before
# the gas comes, beside its twin without. Grains that nothing moves before the first exchange stay as they are,
# so all that is counted on the clock of the gas must be the same. On 1 and 2 ranks, over both transports; then
# the dictionaries are written as OpenFOAM allows, and nothing may change.
set -euo pipefail
root=$1 bin=$2 work=$3
export WM_PROJECT_DIR=${WM_PROJECT_DIR:-/usr/share/openfoam}
export OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1
limit_s=100
settled_steps=3000 gas_steps=5000
same=1e-9       # relative: times in files have nine digits
ranks_apart=1e-3    # relative: the solvers' tolerances, and faces between ranks
status=0
failed() { echo "FAILED: $*" >&2; status=1; }
rm -rf "$work"
mkdir -p "$work"

new_case() {  # name, settled steps
  "$root/scripts/page_files.sh" "$root/docs/first_coupled_job.md" "$work/$1"
  cd "$work/$1"
  mkdir post
  foamDictionary -disableFunctionEntries -entry endTime -set 0.005 system/controlDict >/dev/null 2>&1
  foamDictionary -disableFunctionEntries -entry writeInterval -set 0.0025 system/controlDict >/dev/null 2>&1
  # Weight and gas begin together.
  awk -v settled="$2" -v steps=$gas_steps '
    /^fix +weight/ { weight = $0; next }
    /^fix +gas/ { gas = $0; next }
    /^dump/ { print "dump grains all custom 500 post/particles_*.dump id type x y z vx vy vz radius mass"
              print "dump_modify grains format \"%d %d %.12g %.12g %.12g %.12g %.12g %.12g %.12g %.12g\""
              if (settled) print "run " settled
              print weight; print gas; next }
    /^run/ { print "run " steps; next }
    { print }' in.duct >in.new
  mv in.new in.duct
  blockMesh >log.blockMesh 2>&1
}

mpi() {  # ranks of LIGGGHTS, of powderFoam
  local parallel=
  if (($2 > 1)); then
    parallel=-parallel
    printf 'FoamFile { version 2.0; format ascii; class dictionary; object decomposeParDict; }\n%s\n' \
      "numberOfSubdomains $2; method simple; coeffs { n ($2 1 1); delta 0.001; }" >system/decomposeParDict
    decomposePar >log.decomposePar 2>&1
  fi
  timeout $limit_s mpirun --oversubscribe --bind-to none --mca mpi_yield_when_idle 1 \
    -np "$1" "$bin/liggghts-powderlink" -in in.duct : -np "$2" "$bin/powderFoam" $parallel >job.out 2>&1 ||
    { tail -n 20 job.out >&2; failed "job in $PWD"; }
}

socket() {
  local job
  foamDictionary -entry particleMomentum/transport -set socket constant/couplingProperties >/dev/null 2>&1
  sed -i 's/every 100/& transport socket/' in.duct
  timeout $limit_s "$bin/powderFoam" >solver.txt 2>&1 &
  job=$!
  timeout $limit_s "$bin/liggghts-powderlink" -in in.duct >screen.txt 2>&1 || failed "LIGGGHTS in $PWD"
  wait "$job" || { tail -n 20 solver.txt >&2; failed "powderFoam in $PWD"; }
}

flow() {  # options
  "$bin/powderlink" flow . --no-figures --json flow.json "$@" >flow.txt 2>flow.err ||
    { cat flow.err >&2; failed "flow in $PWD"; }
}
value() { sed -n "s/^ \"$1\": \([^,]*\),*$/\1/p" flow.json; }
close_to() {  # what, value, reference, tolerance
  awk -v a="$2" -v b="$3" -v e="$4" 'BEGIN { d = a - b; if (d < 0) d = -d
    exit !(a != "" && b + 0 != 0 && d <= e*(b < 0 ? -b : b)) }' || failed "$1: $2, right is $3"
}
quantities=(solids_flow_kg_s particle_velocity_mean_m_s pressure_slope_Pa_m)

new_case twin 0
mpi 1 1
flow --from 2e-3
grep -q 'along x through x' flow.txt || failed "the axis of the duct"
[[ -n $(value wall_s_per_simulated_ms) && $(value wall_s_per_simulated_ms) != null ]] || failed "job.out is not read"
declare -A right
for name in "${quantities[@]}"; do right[$name]=$(value $name); done
# Nothing else counts at these times.
flow --from 4e-3
[[ $(value solids_flow_kg_s) != "${right[solids_flow_kg_s]}" ]] || failed "the flow does not depend on --from"

settled_like_twin() {  # tolerance
  local name
  flow --from 2e-3
  for name in "${quantities[@]}"; do close_to "$name in ${PWD##*/}" "$(value $name)" "${right[$name]}" "$1"; done
  # The dump of step N belongs to N dt - 3 ms of gas.
  "$bin/powderlink-render" flow-series . >render.txt 2>&1 || { cat render.txt >&2; failed "flow-series in $PWD"; }
  grep -q 'timestep="0.004" .*particles_7000.vtp' particles.pvd || failed "$PWD: step 7000 is not at 4 ms"
  grep -q 'timestep="-0.003" .*particles_0.vtp' particles.pvd || failed "$PWD: step 0 is not at -3 ms"
  "$bin/powderlink" restart . >restart.txt 2>&1 || { cat restart.txt >&2; failed "restart in $PWD"; }
  grep -q 'time 0.005 s, DEM step 8000' restart.txt || failed "$PWD: $(head -n 1 restart.txt)"
}
new_case settled $settled_steps
mpi 1 1
settled_like_twin $same
new_case ranks $settled_steps
# Compressed and binary, in processors only: written by OpenFOAM, read by its own classes.
foamDictionary -disableFunctionEntries -entry writeFormat -set binary system/controlDict >/dev/null 2>&1
foamDictionary -disableFunctionEntries -entry writeCompression -set on system/controlDict >/dev/null 2>&1
mpi 2 2
rm -rf constant/polyMesh
settled_like_twin $ranks_apart
new_case socket $settled_steps
socket
settled_like_twin $same

# As anyone may write them.
cd "$work/settled"
cat >constant/gas <<'END'
argon { density 1.66; } /* other gases:
rho 998;
*/
END
cat >constant/transportProperties <<'END'
FoamFile { version 2.0; format ascii; class dictionary; object transportProperties; }
/* water
rho             998;
*/
#include "gas"
transportModel Newtonian; rho 998; nu 1.343e-5;
rho             $argon.density;     // the last one counts
END
flow --from 2e-3
close_to "pressure with another spelling of rho" "$(value pressure_slope_Pa_m)" "${right[pressure_slope_Pa_m]}" $same

cat >>system/controlDict <<'END'
/* startFrom latestTime;
startFrom latestTime; */
from startTime; startFrom firstTime; startTime 0; startFrom $from;
END
cp system/controlDict before
"$bin/powderlink" restart . --prepare >prepare.txt 2>&1 || { cat prepare.txt >&2; failed "restart --prepare"; }
[[ $(foamDictionary -entry startFrom -value system/controlDict) == latestTime ]] ||
  failed "OpenFOAM sees startFrom $(foamDictionary -entry startFrom -value system/controlDict)"
[[ $(diff before system/controlDict | grep -c '^[<>]') == 2 ]] || failed "more than one line of controlDict changed"
for name in from startTime endTime functions/axis/probeLocations; do
  [[ $(foamDictionary -entry $name -value system/controlDict) == "$(foamDictionary -entry $name -value before)" ]] ||
    failed "$name changed"
done
exit $status
