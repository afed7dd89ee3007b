#!/usr/bin/env bash
# scripts/plots/plot.sh DIR...: the figures of drop tests as SVG, next to their data.
#   DIR/kat.csv (powderlink kat run)          -> DIR/critical_diameter.svg
#   DIR/kat_results.json, DIR/*/kat_results.json and DIR/row_*/round_1/kat_results.json
#                                         -> residual_velocity.svg beside each
# POWDERLINK_RENDER names another powderlink-render than the one in build/bin or in PATH.
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
limit_s=120

fail() {  # what failed; what was given; what is allowed; what to do
  printf 'plot: %s; given: %s; allowed: %s; to do: %s\n' "$@" >&2
  exit 1
}

staging=$(mktemp -d)
trap 'rm -rf -- "$staging"' EXIT

# A complete figure takes its name; anything less vanishes.
draw() {  # script, figure, gnuplot assignments
  local script=$1 figure=$2
  timeout "$limit_s" gnuplot -e "$3; scripts='$here'; output='$staging/figure.svg'; load '$here/style.gp'" "$here/$script" \
    2>"$staging/messages" || fail "drawing $figure" "$(tail -n 3 "$staging/messages" | tr '\n' ' ')" \
    "a table that gnuplot can read" "check the table's columns and numbers"
  # Keeps blanks at a change of font, and italics in the family of the rest, in every viewer.
  sed -e 's/<text>/<text xml:space="preserve">/' -e 's/font-family="Helvetica" /font-family="Helvetica,Arial,DejaVu Sans,sans-serif" /' \
    "$staging/figure.svg" >"$figure.part" || fail "writing $figure" "folder $(dirname "$figure")" \
    "a folder that may be written to and has space left" "check its rights and space"
   mv -- "$figure.part" "$figure"
  echo "$figure"
}

critical_diameter() {  # folder with kat.csv
  local table=$1/kat.csv summary
  # Checks the table by column names; prints the counts and ranges that the figure needs.
  summary=$(awk -F, '
    function number(text) { return text ~ /^ *[+-]?([0-9]+\.?[0-9]*|\.[0-9]+)([eE][+-]?[0-9]+)? *\r?$/ }
    function bad(text) { print "bad " text; failed = 1; exit }
    /^#/ || /^[ \t\r]*$/ { next }
    !header { sub(/\r$/, ""); for (i = 1; i <= NF; ++i) at[$i] = i; header = 1
      split("impact_velocity_m_s theory_um reduced_um critical_diameter_um largest_attached_um smallest_detached_um measured_um", need, " ")
      for (k = 1; k in need; ++k) if (!(need[k] in at)) bad("no column " need[k]); next }
    { sub(/\r$/, "")
      if (NF < length(at)) bad("line " NR " has " NF " fields")
      for (k = 1; k in need; ++k) { x = $at[need[k]]; if (x != "" && (!number(x) || x <= 0)) bad("line " NR ", column " need[k] ": " x)
        if (x != "") { ++n[k]; if (k == 1) { if (!xl || x + 0 < xl) xl = x + 0; if (x + 0 > xh) xh = x + 0 }
          else { if (!yl || x + 0 < yl) yl = x + 0; if (x + 0 > yh) yh = x + 0 } } } }
    ("adhesive_energy_J_m2" in at) { energies += !seen[$at["adhesive_energy_J_m2"]]++ }
    ("measured_sigma_um" in at) { x = $at["measured_sigma_um"]; if (x != "" && !number(x)) bad("line " NR ", column measured_sigma_um: " x); if (x != "") ++sigmas }
    END { if (failed) exit
      if (!n[1] || !yl) { print "bad no row with a velocity and a diameter"; exit }
      printf "n_theory=%d; n_reduced=%d; n_dem=%d; n_measured=%d; x_low=%g; x_high=%g; y_low=%g; y_high=%g; n_sigma=%d; one_curve=%d", n[2], n[3], n[4], n[7], xl, xh, yl, yh, sigmas, energies < 2 }
  ' "$table")
  [[ $summary != bad* ]] || fail "reading $table" "${summary#bad }" \
    "positive numbers or empty fields under the column names of powderlink kat run" "run powderlink kat run again"
  grep -v '^#' "$table" | tr -d '\r' >"$staging/kat.csv"
  draw critical_diameter.gp "$1/critical_diameter.svg" "table='$staging/kat.csv'; $summary"
}

residual_velocity() {  # folder with kat_results.json
  local summary
  "$render" table "$1" -o "$staging/residual.csv"
  summary=$(awk -F, '
    /^# impact_velocity_m_s/ { split($0, part, " "); v = part[3] }
    /^# critical_diameter_um/ { split($0, part, " "); d = part[3] }
    /^[0-9]/ { if (!low || $1 + 0 < low) low = $1 + 0; if ($1 + 0 > high) high = $1 + 0; if ($2 == 0 && $3 + 0 > y) y = $3 + 0 }
    END { printf "v=%.9g; d_c=%.9g; x_low=%.9g; x_high=%.9g; y_high=%.9g", v, d, low, high, y }' "$staging/residual.csv")
  draw residual_velocity.gp "$1/residual_velocity.svg" "table='$staging/residual.csv'; $summary"
}

[[ $# -gt 0 ]] || fail "no folder" "no argument" "folders of powderlink kat run or of single drop tests" "scripts/plots/plot.sh DIR"
command -v gnuplot >/dev/null || fail "gnuplot is missing" "PATH" "gnuplot 5.4 or later" "run scripts/setup.sh"
render=${POWDERLINK_RENDER:-$here/../../build/bin/powderlink-render}
[[ -x $render ]] || render=$(command -v powderlink-render || true)

for dir in "$@"; do
  dir=${dir%/}
  runs=()
  for results in "$dir/kat_results.json" "$dir"/*/kat_results.json "$dir"/row_*/round_1/kat_results.json; do
    if [[ -f $results ]]; then runs+=("$(dirname "$results")"); fi
  done
  [[ -f $dir/kat.csv || ${#runs[@]} -gt 0 ]] || fail "nothing to draw" "$dir" \
    "a folder with kat.csv or kat_results.json" "give the output folder of powderlink kat run"
  if [[ -f $dir/kat.csv ]]; then critical_diameter "$dir"; fi
  if [[ ${#runs[@]} -gt 0 ]]; then
    [[ -n $render ]] || fail "powderlink-render is missing" "build/bin and PATH" "the built program" "build powderlink first"
    for run in "${runs[@]}"; do residual_velocity "$run"; done
  fi
done
