#!/usr/bin/env bash
# pipe_test.sh TEST SOURCE WORK: see CMakeLists.txt. run.sh itself fails when a grain is missing at any
# of its counts, or the rate or the momentum balance is off.
set -euo pipefail
test=$1 case=$2/foam_cases/pipe out=$3/$1
run() { timeout 170 "$case/run.sh" --short --out "$out" "$@"; }
fail() {
  echo "pipe_test: $*" >&2
  exit 1
}
# A column of the line of a time in post/particle_count.csv.
count() { awk -F, -v t="$2" -v column="$3" 'NR > 1 && $1 > t - 1e-8 && $1 < t + 1e-8 { print $column }' "$1/case/post/particle_count.csv"; }

case $test in
  one_rank) run --end-time 0.003 ;;
  two_ranks) run --end-time 0.002 --ranks 2 --dem-ranks 2 ;;
  socket) run --end-time 0.002 --transport socket ;;
  jkr) run --end-time 0.002 --contact jkr ;;
  continued)
    run --end-time 0.002 --write-interval 0.001
    # Ends after the checkpoint of 1 ms, and loses what it did since.
    run --end-time 0.0015 --write-interval 0.001 --out "$out/stopped"
    run --end-time 0.002 --write-interval 0.001 --out "$out/stopped" --continue
    for column in 2 3 4 6; do  # inserted, inside, escaped, injected mass
      whole=$(count "$out" 0.002 $column) parts=$(count "$out/stopped" 0.002 $column)
      [[ -n $whole && $whole == "$parts" ]] ||
        fail "column $column at 2 ms; uninterrupted: $whole; continued: $parts"
    done
    # Not exact: 2e-4 was measured, LIGGGHTS's new forces of grains in contact are only a part of it
    # (foam_cases/pipe/README.md). To be tightened when the restart is.
    awk -v a="$(count "$out" 0.002 8)" -v b="$(count "$out/stopped" 0.002 8)" \
      'BEGIN { exit !(a > 0 && (a - b)^2 <= (1e-3*a)^2) }' || fail "mean velocity of the grains differs"
    ;;
  *) fail "unknown test $test" ;;
esac
