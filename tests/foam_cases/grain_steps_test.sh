#!/usr/bin/env bash
# grain_steps_test.sh REPOSITORY WORK: how far grains move in a step, as run.sh of the pipe looks at it.
set -euo pipefail
root=$1 work=$2
rm -rf "$work"
mkdir -p "$work"
cd "$work"
dump() {  # speed of the faster of two grains of 10 um radius
  printf 'ITEM: TIMESTEP\n0\nITEM: NUMBER OF ATOMS\n2\nITEM: BOX BOUNDS ff ff ff\n0 1\n0 1\n0 1\n'
  printf 'ITEM: ATOMS id type x y z vx vy vz omegax radius mass\n7 1 0 0 0 3 4 0 900 1e-5 1\n'
  printf '9 1 0 0 0 %s 0 900 1e-5 1\n' "$1"
}
check() { bash -c ". '$root/scripts/foam_case.sh'; foam_case_grain_steps 4e-7 \"\$@\"" check "$@" 2>message; }
dump "0 22.4" >slow.dump
dump "-18.1 13.6" >fast.dump
check slow.dump || { cat message; echo "refused 0.896 of the radius" >&2; exit 1; }
! check slow.dump fast.dump slow.dump || { echo "took 0.906 of the radius" >&2; exit 1; }
for text in "given: in a step it moves 0.906 of its radius: grain 9 in fast.dump" "allowed: at most 0.9" "to do: lower"; do
  grep -qF "$text" message || { cat message >&2; echo "no '$text'" >&2; exit 1; }
done
