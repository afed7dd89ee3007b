#!/usr/bin/env bash
# results.json of a verification case; sourced by scripts/foam_case.sh and scripts/kat_case.sh.
#   case_result NAME UNIT VALUE REFERENCE TOLERANCE SOURCE
#       tolerance: relative to the reference; with a reference of 0 the largest |value|
#   case_write CASE FILE WALL_S RANKS VERSIONS     VERSIONS: "NAME": "VERSION", ...
#       prints FILE too; status 1 if a quantity is outside its tolerance
#   case_path PATH     PATH as it was meant where run.sh was called, which has gone to its own folder
#   case_usage         the comment at the top of run.sh

case_quantities=()
case_caller=${OLDPWD:-$PWD}

case_path() { (cd "$case_caller" && realpath -m -- "$1"); }

case_usage() { awk 'NR > 1 && !/^#/ { exit } NR > 1 { sub(/^# ?/, ""); print }' "${BASH_SOURCE[-1]##*/}"; }

case_result() {
  case_quantities+=("$(awk -v name="$1" -v unit="$2" -v value="$3" -v reference="$4" \
    -v tolerance="$5" -v source="$6" 'BEGIN {
      error = value - reference; if (error < 0) error = -error
      size = reference < 0 ? -reference : reference
      if (size == 0) size = 1
      # An empty or non-numeric value must not pass as 0.
      number = value ~ /^-?[0-9.]+(e[-+]?[0-9]+)?$/
      pass = (number && error <= tolerance*size) ? "true" : "false"
      if (!number) value = "null"
      printf "{\"name\": \"%s\", \"unit\": \"%s\", \"value\": %s, \"reference\": %s, ", name, unit, value, reference
      printf "\"tolerance\": %s, \"source\": \"%s\", \"pass\": %s}", tolerance, source, pass
    }')")
}

case_write() {
  local separator= quantity
  {
    printf '{"case": "%s", "quantities": [' "$1"
    for quantity in "${case_quantities[@]}"; do
      printf '%s\n  %s' "$separator" "$quantity"
      separator=,
    done
    printf '\n], "wall_s": %s, "ranks": %s, "versions": {%s}}\n' "$3" "$4" "$5"
  } >"$2.part"
  mv "$2.part" "$2"
  cat "$2"
  if grep -q '"pass": false' "$2"; then
    echo "run.sh: a quantity is outside its tolerance; see $2" >&2
    return 1
  fi
}
