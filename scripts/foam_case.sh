#!/usr/bin/env bash
# Common part of foam_cases/*/run.sh; sourced, in the folder of the case:
#   foam_case_options "$@"     [--short] [--ranks N] [--out DIR]; sets short, ranks, out
#   foam_case_copy             the native files to $out, and cd there
#   foam_case_run PROGRAM ...  runs it, log.PROGRAM beside the case; its last lines on failure
#   foam_case_solve            decomposes for more than one rank, runs powderFoam; sets wall_s
#   foam_case_result NAME UNIT VALUE REFERENCE TOLERANCE SOURCE   (tolerance: relative)
#   foam_case_write CASE       results.json in $out; exit status 1 if a quantity fails
# powderFoam is taken from POWDERLINK_BIN, else from the repository's build/bin.

foam_case_root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
foam_case_bin=${POWDERLINK_BIN:-$foam_case_root/build/bin}
if [[ -z ${WM_PROJECT_DIR:-} && -d /usr/share/openfoam/etc ]]; then
  export WM_PROJECT_DIR=/usr/share/openfoam
fi

foam_case_fail() {  # what, given, allowed, to do
  printf 'run.sh: %s; given: %s; allowed: %s; to do: %s\n' "$1" "$2" "$3" "$4" >&2
  exit 1
}

foam_case_options() {
  short=no ranks=1 out=$PWD/results
  while [[ $# -gt 0 ]]; do
    case $1 in
      --short) short=yes; shift ;;
      --ranks | --out)
        [[ $# -ge 2 ]] || foam_case_fail "option without a value" "$1" "$1 VALUE" "add the value"
        if [[ $1 == --ranks ]]; then ranks=$2; else out=$(realpath -m -- "$2"); fi
        shift 2 ;;
      *) foam_case_fail "unknown option" "$1" "--short, --ranks N, --out DIR" "correct it" ;;
    esac
  done
  [[ $ranks =~ ^[1-9][0-9]*$ ]] ||
    foam_case_fail "bad number of ranks" "$ranks" "an integer, at least 1" "correct --ranks"
  [[ -x $foam_case_bin/powderFoam ]] ||
    foam_case_fail "powderFoam is missing" "$foam_case_bin" "a folder with powderFoam" \
      "build it: scripts/build.sh; or set POWDERLINK_BIN"
}

foam_case_copy() {
  foam_case_results=$PWD/results.json
  if [[ $out != "$PWD/results" ]]; then foam_case_results=$out/results.json; fi
  rm -f "$foam_case_results"
  rm -rf "$out/case"
  mkdir -p "$out/case"
  cp -r 0 constant system "$out/case"
  cd "$out/case"
  if [[ $short == yes ]]; then cp system/caseSettings.short system/caseSettings; fi
  foam_case_quantities=()
}

foam_case_run() {
  local log
  log=log.$(basename "$1")
  if ! "$@" >"$log" 2>&1; then
    tail -n 25 "$log" >&2
    foam_case_fail "$(basename "$1") failed" "$*" "exit status 0" "see $PWD/$log"
  fi
}

foam_case_solve() {
  local start end
  local solver=("$foam_case_bin/powderFoam")
  if ((ranks > 1)); then
    sed -i -E "s/^(numberOfSubdomains).*/\1 $ranks;/; s/^( *n ).*/\1(1 1 $ranks);/" \
      system/decomposeParDict
    foam_case_run decomposePar
    # Not bound: other runs on the machine would be bound to the same cores.
    solver=(mpirun -np "$ranks" --oversubscribe --bind-to none --mca mpi_yield_when_idle 1
      "${solver[@]}" -parallel)
    if [[ $(id -u) == 0 ]]; then
      export OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1
    fi
  fi
  echo "powderFoam on $ranks rank(s); log: $PWD/log.${solver[0]##*/}"
  start=$(date +%s.%N)
  foam_case_run "${solver[@]}"
  end=$(date +%s.%N)
  wall_s=$(awk -v a="$start" -v b="$end" 'BEGIN { printf "%.3f", b - a }')
}

foam_case_result() {
  foam_case_quantities+=("$(awk -v name="$1" -v unit="$2" -v value="$3" -v reference="$4" \
    -v tolerance="$5" -v source="$6" 'BEGIN {
      error = value - reference; if (error < 0) error = -error
      size = reference < 0 ? -reference : reference
      # An empty or non-numeric value must not pass as 0.
      pass = (value ~ /^-?[0-9.]+(e[-+]?[0-9]+)?$/ && error <= tolerance*size) ? "true" : "false"
      if (value !~ /^-?[0-9.]+(e[-+]?[0-9]+)?$/) value = "null"
      printf "{\"name\": \"%s\", \"unit\": \"%s\", \"value\": %s, \"reference\": %s, ", name, unit, value, reference
      printf "\"tolerance\": %s, \"source\": \"%s\", \"pass\": %s}", tolerance, source, pass
    }')")
}

foam_case_write() {
  local separator=
  {
    printf '{"case": "%s", "quantities": [' "$1"
    for quantity in "${foam_case_quantities[@]}"; do
      printf '%s\n  %s' "$separator" "$quantity"
      separator=,
    done
    printf '\n], "wall_s": %s, "ranks": %s, "versions": {"openfoam": "%s"}}\n' "$wall_s" "$ranks" \
      "$(sed -n -E 's/^Build *: *(.*[^ ]) *$/\1/p' log.powderFoam log.mpirun 2>/dev/null | head -n 1)"
  } >"$foam_case_results.part"
  mv "$foam_case_results.part" "$foam_case_results"
  cat "$foam_case_results"
  if grep -q '"pass": false' "$foam_case_results"; then
    echo "run.sh: a quantity is outside its tolerance; see $foam_case_results" >&2
    exit 1
  fi
}
