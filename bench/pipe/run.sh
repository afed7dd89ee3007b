#!/usr/bin/env bash
# bench/pipe/run.sh [--mppic PROGRAM|build|no] [--layout DEM+CFD] [--steps N]: wall time per simulated
# ms of pipe case A (--inputs assumed) from the filled state, powderlink against stock DPMFoam and MP-PIC
# on two ranks, with the same mesh, gas, grains (positions, velocities, diameters) and pressure solver.
#   powderlink  2 ms of warm-up, then 2 ms; each 5000 DEM steps
#   CPU         of the fluid's program on its first rank, waiting for other ranks included
#   stock       2 steps of warm-up, then N steps (default 10; MP-PIC 4 N) of 5 us; extrapolated to 1 ms;
#               with our pressure solver, MP-PIC also with that of OpenFOAM's tutorials
# MPPICFoam: 'build' (default) compiles it again (build_mppic.sh), as the packaged one diverges here.
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
root=$(cd "$here/../.." && pwd)
mppic=build layout=2+2 steps=10 stock_ranks=2 stock_dt_s=5e-6 time_limit_s=1800
while [[ $# -gt 0 ]]; do
  case $1 in
    --mppic) mppic=${2:?}; shift 2 ;;
    --layout) layout=${2:?}; shift 2 ;;
    --steps) steps=${2:?}; shift 2 ;;
    *) echo "bench/pipe; given: $1; allowed: --mppic, --layout, --steps; to do: correct it" >&2; exit 2 ;;
  esac
done
if [[ $mppic == build ]]; then
  mppic=$root/build/mppic/MPPICFoam
  "$here/build_mppic.sh" "$root/build/mppic" || mppic=no
fi
# Whatever runs here ends with this script.
work=$(mktemp -d)
trap 'kill $(jobs -p) 2>/dev/null || true; rm -rf "$work"' EXIT
if [[ -z ${WM_PROJECT_DIR:-} && -d /usr/share/openfoam/etc ]]; then
  export WM_PROJECT_DIR=/usr/share/openfoam
fi
export OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1

# In a copy; all digits of the other entries stay with this precision.
set_entry() {  # file, entry, value
  foamDictionary -precision 15 -disableFunctionEntries -entry "$2" -set "$3" "$1" >/dev/null
}

# Highest resident memory [MB] of each program that runs in a folder; to FILE until it is killed.
watch_memory() {  # folder, file
  local pid
  while sleep 0.5; do
    for pid in $(pgrep 'Foam|liggghts'); do
      [[ $(readlink "/proc/$pid/cwd") == "$1" ]] || continue
      awk -v pid="$pid" '/^Name/ { name = $2 } /^VmHWM/ { print pid, name, $2/1024 }' \
        "/proc/$pid/status" 2>/dev/null >>"$2" || true
    done
  done
}
memory() {  # file, program
  awk -v name="$2" '$2 == name && $3 > most { most = $3 } END { printf "%.0f", most }' "$1"
}

table=()
row() { table+=("$(printf '%-20s %-16s %14s %8s %14s %14s %10s' "$@")"); }

cpu_s_per_ms() {  # log, from s, to s: by the fluid's program
  sed -E 's/^[0-9.]+ Time =/Time =/' "$1" | awk -v from="$2" -v to="$3" '
    $1 == "Time" { time = $3 }
    $1 == "ExecutionTime" && time <= from*(1 + 1e-9) { a = $3; start = time }
    $1 == "ExecutionTime" && time <= to*(1 + 1e-9) { b = $3; end = time }
    END { if (end > start) printf "%.3g", (b - a)*1e-3/(end - start); else print "-" }'
}

powderlink() {
  watch_memory "$work/powderlink/case" "$work/memory" &
  local watcher=$!
  "$root/foam_cases/pipe/run.sh" --filled --case A --inputs assumed --end-time 0.004 --write-interval 0.002 \
    --dem-ranks "${layout%+*}" --ranks "${layout#*+}" --out "$work/powderlink" >"$work/log" 2>&1 || {
    tail -n 20 "$work/log" >&2
    exit 1
  }
  kill "$watcher"
  # Wall seconds of LIGGGHTS's clock from 2 to 4 ms.
  own_s=$(awk '$1 == 5000 { a = $2 } $1 == 10000 { b = $2 } END { printf "%.3f", (b - a)/2 }' \
    "$work/powderlink/case/log.liggghts")
  share=$(sed -n -E 's/.*coupling share[^0-9]*([0-9]+\.?[0-9]?)[0-9]* *%.*/\1/p' "$work/powderlink/case/log.powderFoam" | tail -n 1)
  row "powderlink" "${layout%+*} DEM + ${layout#*+} CFD" "$own_s" 1 \
    "$(cpu_s_per_ms "$work/powderlink/case/log.powderFoam" 0.002 0.004)" \
    "$(memory "$work/memory" liggghts-powder)+$(memory "$work/memory" powderFoam)" "${share:--}"
}

stock() {  # name, program, steps, pressure solver: ours or tutorial
  local folder=$work/$1.$4 from=$work/powderlink/case fields
  mkdir "$folder"
  cp -r "$here"/stock/* "$folder"
  cp "$here/$1"/constant/* "$folder/constant"
  cp "$from"/system/{caseSettings,blockMeshDict,decomposeParDict} "$folder/system"
  if [[ $4 == ours ]]; then cp "$from/system/fvSolution" "$folder/system"; fi
  cp -r "$from/constant/polyMesh" "$folder/constant"
  cd "$folder"
  # Gas and grains of the filled state at 2 ms.
  fields=$from/0.002
  if [[ ! -d $fields ]]; then
    (cd "$from" && reconstructPar -time 0.002 -fields '(U)' >log.reconstructPar)
  fi
  LC_ALL=C sed 's/object  *U;/object      U.air;/' "$fields/U" >0/U.air
  # LIGGGHTS deletes grains at the next rebuild of its lists after the outlet: not those beyond it.
  awk '
    grains && $5 < 0.29998 { grain[++n] = sprintf("(%s %s %s) (%s %s %s) %.9g 7950 1e-9", $3, $4, $5, $6, $7, $8, 2*$12) }
    /^ITEM: ATOMS/ { grains = 1 }
    END {
      print "FoamFile\n{\n    version 2.0;\n    format ascii;\n    class dictionary;\n    object grains;\n}\n"
      print n "\n("
      for (i = 1; i <= n; i++) print grain[i]
      print ")"
    }' "$from/post/particles_5000.dump" >constant/grains
  set_entry system/controlDict endTime "$(awk "BEGIN { print ($3 + 2)*$stock_dt_s }")"
  set_entry system/decomposeParDict numberOfSubdomains "$stock_ranks"
  set_entry system/decomposeParDict coeffs/n "(1 1 $stock_ranks)"
  decomposePar >log.decomposePar
  watch_memory "$folder" "$folder/memory" &
  local watcher=$!
  # Every step's line with the time of day.
  timeout "$time_limit_s" mpirun -np $stock_ranks --oversubscribe --bind-to none \
    --mca mpi_yield_when_idle 1 "$2" -parallel 2>&1 |
    while IFS= read -r line; do
      case $line in
        "Time = "* | End) printf '%s %s\n' "$EPOCHREALTIME" "$line" ;;
        *) printf '%s\n' "$line" ;;
      esac
    done >log.solver || {
    tail -n 20 log.solver >&2
    exit 1
  }
  kill "$watcher"
  awk '$2 == "End" || $2 == "Time" { t[++n] = $1 } END { exit n < 4 }' log.solver || {
    tail -n 20 log.solver >&2
    exit 1
  }
  local wall
  wall=$(awk -v dt="$stock_dt_s" '$2 == "End" || $2 == "Time" { t[++n] = $1 }
    END { printf "%.1f", (t[n] - t[3])/(n - 3)*1e-3/dt }' log.solver)
  row "$1, $4" "$stock_ranks" "$wall" "$(awk "BEGIN { r = $wall/$own_s; printf r < 30 ? \"%.1f\" : \"%.0f\", r }")" \
    "$(cpu_s_per_ms log.solver "$(awk "BEGIN { print 2*$stock_dt_s }")" 1)" \
    "$(memory memory "$(basename "$2")")" -
}

echo "gas alone, then 4 ms of powderlink ($layout ranks)..." >&2
powderlink
echo "DPMFoam, $((steps + 2)) steps..." >&2
stock DPMFoam DPMFoam "$steps" ours
if [[ $mppic != no ]]; then
  for solver in ours tutorial; do
    echo "MPPICFoam, $((4*steps + 2)) steps, pressure solver: $solver..." >&2
    stock MPPICFoam "$mppic" $((4*steps)) $solver
  done
fi
printf '%-20s %-16s %14s %8s %14s %14s %10s\n' solver ranks "wall s per ms" ratio "CPU s per ms" \
  "MB/process" "coupling %"
printf '%s\n' "${table[@]}"
