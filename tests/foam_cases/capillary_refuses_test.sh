#!/usr/bin/env bash
# capillary_refuses_test.sh REPOSITORY WORK: what run.sh of the capillary refuses, with the numbers, and its
# powder and window beside their definitions.
set -euo pipefail
case=$1/foam_cases/capillary work=$2
rm -rf "$work"
mkdir -p "$work"
status=0
failed() { echo "FAILED: $*" >&2; status=1; }

refused() {  # options; texts of the message
  local code=0 text
  # shellcheck disable=SC2086  # options of our own, without blanks
  "$case/run.sh" --short --out "$work/run" $1 >"$work/out" 2>"$work/err" || code=$?
  [[ $code == 1 ]] || failed "$1: exit status $code"
  shift
  for text in "; given: " "; allowed: " "; to do: " "$@"; do
    grep -qF -- "$text" "$work/err" || failed "the message lacks '$text': $(cat "$work/err")"
  done
}
refused "--flow 0.3" "given: 0.3 L/min" "0.2 0.4 0.6 0.8 1.0"
refused "--inlet round" "given: round" "plug, parabolic"
refused "--powder-velocity 0" "given: 0" "--powder-velocity"
refused "--powder-flow lots" "given: lots" "--powder-flow"
refused "--powder-flow" "option without a value"
# 0.9 radii of the smallest grain, 16.6366 um, in 0.4 us.
refused "--flow 0.8 --powder-velocity 40" "given: 40 m/s" "37.43235 m/s"
refused "--flow 0.8 --powder-velocity 0.01" "0.03 g/s at 0.01 m/s fill 0.449" "at most 0.2"

# A quarter of all grains by number, in classes of the same mass: D10, D50 and D90 of what LIGGGHTS draws.
"$case/make_powder.sh" 45 106 7980 >"$work/in.powder"
awk '
  /particletemplate/ { for (i = 1; i < NF; i++) if ($i == "radius") d[$2] = 2e6*$(i + 2) }
  /^    class/ { share[$1] = $2; sum += $2; mass += $2*d[$1]^3; order[++n] = $1 }
  /^variable grainMass/ { mean = $4 }
  # The share by mass up to the middle of class i is (i - 0.5)/n.
  function quantile(q,  i, y) { y = q*n + 0.5; i = int(y); return d[order[i]] + (y - i)*(d[order[i + 1]] - d[order[i]]) }
  function near(what, value, right, tolerance) {
    if (value < right - tolerance || value > right + tolerance) { print what ": " value ", right is " right; wrong = 1 }
  }
  END {
    near("sum of the shares", sum, 1, 1e-5)
    for (i = 1; i <= n; i++) near("mass of " order[i], share[order[i]]*d[order[i]]^3/mass, 1/n, 1e-4)
    near("D10", quantile(0.1), 45, 0.2)    # a straight line between two classes
    near("D90", quantile(0.9), 106, 0.5)
    near("mean mass over 1e-10 kg", 1e10*mean, 1e-8*7980*atan2(0, -1)/6*mass, 1e-3)
    exit wrong
  }' "$work/in.powder" || failed "the powder"

# Two grains at 2 and 4 m/s, 0.2 and 0.4 mm above the bottom: the slow one is in all of 41 frames, the fast
# one in every second, so that the window sees two of the slow one for each of the fast one.
awk 'BEGIN {
  for (f = 0; f <= 40; f++) {
    printf "ITEM: TIMESTEP\n%d\nITEM: NUMBER OF ATOMS\n%d\nITEM: BOX BOUNDS ff ff ff\n0 1\n0 1\n0 1\n", 1000 + 100*f, 1 + (f%2 == 0)
    print "ITEM: ATOMS id x y z vx vy vz radius mass"
    print 1, 0, -3e-4, 0.0375, 0, 0, 2, 3e-5, 1e-9
    if (f%2 == 0) print 2, 0, -1e-4, 0.0375, 0, 0, 4, 3e-5, 1e-9
  } }' >"$work/window.dump"
awk -v from=1100 -v last=5000 -v radius=5e-4 -f "$case/window.awk" "$work/window.dump" >"$work/seen"
awk 'function near(what, value, right, error) {
    if (value < right - error || value > right + error) { print what ": " value ", right is " right; wrong = 1 } }
  { near("frames", $1, 40, 0); near("grains in a frame", $2, 1.5, 0.001)
    near("velocity", $3, 8/3, 1e-4); near("its deviation", $5, sqrt(8)/3, 1e-4)
    near("height", $6, 0.8/3*1e-3, 1e-8); near("its deviation", $8, sqrt(8)/3*1e-4, 1e-8)
    near("mass flow", $9, 4e-9/0.003, 1e-10)
    # Every block of two frames is the same.
    near("error of the velocity", $4, 0, 1e-9); near("error of the mass flow", $10, 0, 1e-12) }
  END { exit wrong || NR != 1 }' "$work/seen" || failed "the window: $(cat "$work/seen")"
exit $status
