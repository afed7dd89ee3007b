#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Open MPI 4.1.4 (Debian package openmpi-bin): mpirun that gets SIGTERM ends its programs and then itself, after 1 s.
# With a second SIGTERM right behind the first one it ends at once and leaves the programs at work. Two are what it
# gets when a process group is signalled in which `timeout --foreground mpirun ...` runs: one of the group, one that
# timeout passes on. Programs of a coupled run then go on writing beside those that are started to continue it.
# Fails (status 1) if that changes.
set -euo pipefail
version=$(dpkg-query -W -f '${Version}' openmpi-bin)
work=$(mktemp -d); trap 'rm -rf "$work"' EXIT; cd "$work"
export OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1

left_at_work() {  # signals; prints how many of two programs are there 2 s after mpirun has ended
  local job count=0 pid
  rm -f pid.*
  # Programs that end by themselves after 20 s.
  mpirun --oversubscribe -np 2 bash -c 'echo $$ >pid.$$; exec sleep 20' >log 2>&1 &
  job=$!
  for _ in {1..100}; do [[ $(find . -name 'pid.*' -size +0 | wc -l) -lt 2 ]] || break; sleep 0.1; done
  for ((i = 0; i < $1; i++)); do kill -TERM $job 2>/dev/null || true; sleep 0.1; done
  wait $job || true
  sleep 2
  for pid in $(cat pid.*); do
    if kill -0 "$pid" 2>/dev/null; then count=$((count + 1)); kill -KILL "$pid"; fi
  done
  echo $count
}
one=$(left_at_work 1) two=$(left_at_work 2)
echo "openmpi-bin $version: after one SIGTERM $one of 2 programs are at work, after two $two"
[[ $one == 0 && $two == 2 ]]
