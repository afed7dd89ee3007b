#!/usr/bin/env bash
# Common part of foam_cases/*/run.sh; sourced, in the folder of the case:
#   foam_case_options "$@"     [--short] [--ranks N] [--out DIR], and for coupled cases [--dem-ranks N]
#                              [--transport mpi|socket]; sets short, ranks, out, dem_ranks, transport
#   foam_case_copy [FOLDER]    the native files (of FOLDER) to $out/case, and cd there; with a name in
#                              case_copy: to $out/$case_copy
#   foam_case_entry FILE ENTRY    what OpenFOAM sees in a dictionary of the run; fails when it is not there
#   foam_case_set FILE ENTRY VALUE    gives an entry of the run's copy a value
#   foam_case_end FULL SHORT STEP    end time [s] of the form, into system/caseSettings and end_s; steps of
#                              LIGGGHTS until then, of STEP seconds each, into dem_steps
#   foam_case_run PROGRAM ...  runs it, log.PROGRAM beside the case; its last lines on failure
#   foam_case_decompose        for more than one rank, along decompose_axis (x, y or z; default z)
#   foam_case_solve            decomposes, runs powderFoam; adds to wall_s
#   foam_case_couple SCRIPT [OPTIONS]    decomposes, runs powderFoam and liggghts-powderlink -in SCRIPT
#                              OPTIONS as one coupled job; log.powderFoam, log.liggghts.screen; adds to
#                              wall_s; OPTIONS are for LIGGGHTS (-var NAME VALUE)
#   foam_case_result NAME UNIT VALUE REFERENCE TOLERANCE SOURCE   as case_result (case_results.sh)
#   foam_case_grain_steps STEP DUMP...    stops the run of the script when a grain of the dumps moves so far in
#                              a step of STEP seconds that fix massflow/mesh may not count it
#   foam_case_closure NAME     the worst balance of an exchange in powderFoam's own sums as a quantity
#   foam_case_write CASE       results.json in $out; exit status 1 if a quantity fails
# The programs are taken from POWDERLINK_BIN, else from the repository's build/bin.
# POWDERLINK_CASE_LIMIT_S: longest time of a solver run, default 3600 s.

foam_case_root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
foam_case_bin=${POWDERLINK_BIN:-$foam_case_root/build/bin}
foam_case_limit_s=${POWDERLINK_CASE_LIMIT_S:-3600}
foam_case_peer_limit_s=15  # after one program of a coupled job has failed, for the other one
foam_case_kill_after_s=10
foam_case_programs_end_s=30  # for those of a run that was ended
. "$foam_case_root/scripts/case_results.sh"
if [[ -z ${WM_PROJECT_DIR:-} && -d /usr/share/openfoam/etc ]]; then
  export WM_PROJECT_DIR=/usr/share/openfoam
fi
# Not bound: other runs on the machine would be bound to the same cores.
foam_case_mpirun=(mpirun --oversubscribe --bind-to none --mca mpi_yield_when_idle 1)
if [[ $(id -u) == 0 ]]; then
  export OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1
fi

foam_case_fail() {  # what, given, allowed, to do
  printf '%s: %s; given: %s; allowed: %s; to do: %s\n' "${0##*/}" "$1" "$2" "$3" "$4" >&2
  exit 1
}

foam_case_options() {
  short=no ranks=1 dem_ranks=1 transport=mpi out=$PWD/results wall_s=0
  local value
  while [[ $# -gt 0 ]]; do
    case $1 in
      -h | --help) case_usage; exit 0 ;;
      --short) short=yes; shift ;;
      --ranks | --dem-ranks | --transport | --out)
        [[ $# -ge 2 ]] || foam_case_fail "option without a value" "$1" "$1 VALUE" "add the value"
        value=$2
        case $1 in
          --ranks) ranks=$value ;;
          --dem-ranks) dem_ranks=$value ;;
          --transport) transport=$value ;;
          --out) out=$(case_path "$value") ;;
        esac
        shift 2 ;;
      *) foam_case_fail "unknown option" "$1" \
        "--short, --ranks N, --dem-ranks N, --transport mpi|socket, --out DIR" "correct it" ;;
    esac
  done
  for value in "$ranks" "$dem_ranks"; do
    [[ $value =~ ^[1-9][0-9]*$ ]] || foam_case_fail "bad number of ranks" "$value" \
      "an integer, at least 1" "correct --ranks or --dem-ranks"
  done
  [[ $transport == mpi || $transport == socket ]] ||
    foam_case_fail "unknown transport" "$transport" "mpi, socket" "correct --transport"
  foam_case_need powderFoam
  foam_case_results=$PWD/results.json
  if [[ $out != "$PWD/results" ]]; then foam_case_results=$out/results.json; fi
  rm -f "$foam_case_results"
}

foam_case_need() {  # program
  [[ -x $foam_case_bin/$1 ]] || foam_case_fail "$1 is missing" "$foam_case_bin" \
    "a folder with $1" "build it: scripts/build.sh release programs; or set POWDERLINK_BIN"
}

# The programs of a coupled job hold a lock in its folder as long as they live. mpirun leaves them behind,
# at work, when it gets a second signal soon after the first (findings/mpirun_second_signal.sh): what
# removed or continued the run would mix with them.
foam_case_wait_for_programs() {  # folder
  local lock=$1/.programs.lock
  [[ ! -e $lock ]] || flock --timeout "$foam_case_programs_end_s" "$lock" true ||
    foam_case_fail "programs of an earlier run are still at work" "$1, $foam_case_programs_end_s s" \
      "a folder in which nothing runs" "wait for them, or end them: fuser $lock names them"
}

foam_case_copy() {
  local from=${1:-.} folder=$out/${case_copy:-case} script
  # A run's folder is made anew; what is none must not vanish.
  [[ ! -e $folder || -f $folder/system/controlDict ]] || foam_case_fail "the folder of the run is in use" \
    "$folder" "a folder that does not exist, or of an earlier run" "give another --out, or move it away"
  foam_case_wait_for_programs "$folder"
  rm -rf "$folder"
  mkdir -p "$folder"
  cp -r "$from"/{0,constant,system} "$folder"
  for script in "$from"/in.*; do
    if [[ -f $script ]]; then
      mkdir -p "$folder/post"
      cp "$script" "$folder"
    fi
  done
  cd "$folder"
  if [[ $short == yes && -f system/caseSettings.short ]]; then
    cp system/caseSettings.short system/caseSettings
  fi
}

foam_case_entry() {  # file, entry
  foamDictionary -precision 15 -entry "$2" -value "$1" 2>/dev/null || foam_case_fail "an entry is missing" \
    "$2 in $PWD/$1" "a dictionary with that entry" "add it to the case's own file"
}

# All digits of the other entries stay with this precision, macros and includes as they are.
foam_case_set() {  # file, entry, value
  foamDictionary -precision 15 -disableFunctionEntries -entry "$2" -set "$3" "$1" >log.foamDictionary 2>&1 ||
    foam_case_fail "an entry cannot be set" "$2 in $PWD/$1" "a dictionary that OpenFOAM reads" \
      "see $PWD/log.foamDictionary"
}

foam_case_end() {  # full, short, step of LIGGGHTS
  end_s=$1
  if [[ $short == yes ]]; then end_s=$2; fi
  foam_case_set system/caseSettings endTime "$end_s"
  dem_steps=$(awk -v t="$end_s" -v dt="$3" 'BEGIN { printf "%d", t/dt + 0.5 }')
}

foam_case_run() {
  local log
  log=log.$(basename "$1")
  if ! timeout --foreground --kill-after="$foam_case_kill_after_s" "$foam_case_limit_s" "$@" >"$log" 2>&1; then
    tail -n 25 "$log" >&2
    foam_case_fail "$(basename "$1") failed" "$*" "exit status 0 within $foam_case_limit_s s" \
      "see $PWD/$log"
  fi
}

foam_case_decompose() {
  local parts=(1 1 1)
  if ((ranks > 1)); then
    case ${decompose_axis:-z} in
      x) parts=("$ranks" 1 1) ;;
      y) parts=(1 "$ranks" 1) ;;
      z) parts=(1 1 "$ranks") ;;
    esac
    foam_case_set system/decomposeParDict numberOfSubdomains "$ranks"
    foam_case_set system/decomposeParDict coeffs/n "(${parts[*]})"
    foam_case_run decomposePar
  fi
}

foam_case_add_time() {  # start; the end is now
  wall_s=$(awk -v sum="$wall_s" -v a="$1" -v b="$(date +%s.%N)" 'BEGIN { printf "%.3f", sum + b - a }')
}

foam_case_solve() {
  local start
  local solver=("$foam_case_bin/powderFoam")
  foam_case_decompose
  if ((ranks > 1)); then
    solver=("${foam_case_mpirun[@]}" -np "$ranks" "${solver[@]}" -parallel)
  fi
  echo "powderFoam on $ranks rank(s); log: $PWD/log.${solver[0]##*/}"
  start=$(date +%s.%N)
  foam_case_run "${solver[@]}"
  foam_case_add_time "$start"
}

foam_case_coupled_failed() {  # how it ended
  tail -n 15 log.liggghts.screen log.powderFoam log.mpirun >&2 2>/dev/null || true
  foam_case_fail "the coupled job failed" "$1" "both programs end with status 0" \
    "see log.liggghts.screen and log.powderFoam in $PWD"
}

foam_case_couple() {
  local script=$1 start status=0 dem_status=0
  shift
  # See foam_case_wait_for_programs.
  local hold=(bash -c 'exec 8>>.programs.lock; flock --shared --timeout 10 8 && exec "$@"' hold)
  local dem=("${hold[@]}" "$foam_case_bin/liggghts-powderlink" -in "$script" -var transport "$transport" "$@")
  local solver=("${hold[@]}" "$foam_case_bin/powderFoam")
  local limit=(timeout --foreground --kill-after="$foam_case_kill_after_s" "$foam_case_limit_s")
  # Each program writes a log of its own; all ranks append, only the first one has much to say.
  local to_log='log=$1; shift; exec "$@" >>"$log" 2>&1'
  foam_case_need liggghts-powderlink
  foam_case_decompose
  if ((ranks > 1)); then solver+=(-parallel); fi
  rm -f log.liggghts.screen log.powderFoam log.mpirun bridge.address
  echo "powderFoam on $ranks rank(s), LIGGGHTS on $dem_ranks rank(s), over $transport; in $PWD"
  start=$(date +%s.%N)
  if [[ $transport == mpi ]]; then
    "${limit[@]}" "${foam_case_mpirun[@]}" \
      -np "$dem_ranks" bash -c "$to_log" dem log.liggghts.screen "${dem[@]}" : \
      -np "$ranks" bash -c "$to_log" solver log.powderFoam "${solver[@]}" >log.mpirun 2>&1 ||
      status=$?
    ((status == 0)) || foam_case_coupled_failed "exit status $status"
  else
    foam_case_set constant/couplingProperties particleMomentum/transport socket
    foam_case_socket_job || foam_case_coupled_failed "exit status $status (powderFoam), $dem_status (LIGGGHTS)"
  fi
  foam_case_add_time "$start"
}

# Two jobs of their own; uses the variables of foam_case_couple.
foam_case_socket_job() {
  local solver_job dem_job
  if ((ranks > 1)); then solver=("${foam_case_mpirun[@]}" -np "$ranks" "${solver[@]}"); fi
  if ((dem_ranks > 1)); then dem=("${foam_case_mpirun[@]}" -np "$dem_ranks" "${dem[@]}"); fi
  "${limit[@]}" "${solver[@]}" >log.powderFoam 2>&1 &
  solver_job=$!
  "${limit[@]}" "${dem[@]}" >log.liggghts.screen 2>&1 &
  dem_job=$!
  trap 'kill "$solver_job" "$dem_job" 2>/dev/null || true' EXIT
  # The first that fails takes the other one with it, after a while to say why.
  if ! wait -n; then
    sleep "$foam_case_peer_limit_s" >/dev/null 2>&1 &
    wait -n || true
    kill "$solver_job" "$dem_job" 2>/dev/null || true
  fi
  wait "$solver_job" || status=$?
  wait "$dem_job" || dem_status=$?
  trap - EXIT
  ((status == 0 && dem_status == 0))
}

foam_case_result() { case_result "$@"; }

# fix massflow/mesh looks at grains that touch its mesh: one that is before it at a step and behind it,
# out of touch, at the next has not been seen.
foam_case_grain_steps() {  # time step of LIGGGHTS, dumps with vx vy vz radius
  local step_s=$1 most=0.9 fastest
  shift
  fastest=$(awk -v dt="$step_s" '
    /^ITEM: ATOMS/ { split("", column); for (i = 3; i <= NF; i++) column[$i] = i - 2; rows = 1; next }
    /^ITEM:/ { rows = 0 }
    rows { far = dt*sqrt($column["vx"]^2 + $column["vy"]^2 + $column["vz"]^2)/$column["radius"]
      if (far > most) { most = far; what = sprintf("%.3g of its radius: grain %d in %s", far, $column["id"], FILENAME) } }
    END { print most + 0, what }' "$@")
  awk -v far="${fastest%% *}" -v most="$most" 'BEGIN { exit far > most }' || foam_case_fail \
    "a grain may pass the mesh of fix massflow/mesh uncounted" "in a step it moves ${fastest#* }" \
    "at most $most of the radius" "lower the time step in the LIGGGHTS script"
}

foam_case_closure() {  # name
  local closure
  closure=$(awk '/^momentum \[N s\]:/ { n++; if ($NF > worst) worst = $NF } END { if (n) printf "%.3e", worst }' \
    log.powderFoam)
  foam_case_result "$1" 1 "$closure" 0 1e-10 \
    "powderFoam's own sum after each exchange: fluid, particles and what is open, over what was exchanged"
}

foam_case_write() {
  local openfoam liggghts
  # Of a job on several ranks without LIGGGHTS the log is mpirun's.
  openfoam=$(cat log.powderFoam log.mpirun 2>/dev/null | sed -n -E 's/^Build *: *(.*[^ ]) *$/\1/p' |
    head -n 1) || true
  liggghts=$(sed -n -E 's/^LIGGGHTS \(Version ([^,]*),.*/\1/p' log.liggghts 2>/dev/null |
    head -n 1) || true
  case_write "$1" "$foam_case_results" "$wall_s" "$ranks" \
    "\"openfoam\": \"$openfoam\"${liggghts:+, \"liggghts\": \"$liggghts\"}" || exit 1
}
