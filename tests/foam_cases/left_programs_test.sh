#!/usr/bin/env bash
# left_programs_test.sh REPOSITORY WORK: a run is not continued or removed while programs of its folder
# are at work. Each rank holds the lock of scripts/foam_case.sh; here a program that only waits does.
set -euo pipefail
root=$1 work=$2
rm -rf "$work"
mkdir -p "$work/case"
cd "$work"
wait_for() {  # longest time [s]
  bash -c ". '$root/scripts/foam_case.sh'; foam_case_programs_end_s=$1; foam_case_wait_for_programs case" 2>message
}
wait_for 1 || { echo "refused a folder in which nothing has run" >&2; exit 1; }
for rank in 1 2; do flock --shared case/.programs.lock sleep 3 & done
until [[ -e case/.programs.lock ]] && ! flock --nonblock case/.programs.lock true; do sleep 0.05; done
! wait_for 1 || { echo "did not notice two programs at work" >&2; exit 1; }
for text in "programs of an earlier run are still at work; given: case" "allowed: " "to do: "; do
  grep -qF "$text" message || { cat message >&2; echo "no '$text'" >&2; exit 1; }
done
wait_for 30 || { cat message >&2; echo "did not see their end" >&2; exit 1; }
wait
