#!/usr/bin/env bash
# transports_test.sh CASE RANKS DEM_RANKS WORK: the same case as one MPI job and as two jobs over a
# socket gives the same particles in every dump, to round-off.
set -euo pipefail
case_folder=$1 ranks=$2 dem_ranks=$3 work=$4
rm -rf "$work"
mkdir -p "$work"
for transport in mpi socket; do
  "$case_folder/run.sh" --short --ranks "$ranks" --dem-ranks "$dem_ranks" --transport "$transport" \
    --out "$work/$transport"
done

# Sorted by id: ranks write in the order in which they come.
states() {  # folder
  local dump
  for dump in "$1"/case/post/particles_*.dump; do
    awk -v name="$(basename "$dump")" '/^ITEM: ATOMS/ { rows = 1; next } /^ITEM/ { rows = 0 } rows { print name, $0 }' "$dump"
  done | sort -k 1,1 -k 2,2n
}
states "$work/mpi" >"$work/mpi.txt"
states "$work/socket" >"$work/socket.txt"
[[ -s $work/mpi.txt ]] || { echo "FAILED: no particles in the dumps" >&2; exit 1; }

# Both runs do the same sums in the same order.
round_off=1e-12
paste -d ' ' "$work/mpi.txt" "$work/socket.txt" | awk -v tolerance="$round_off" '
  {
    n = NF/2
    if (n != int(n) || $1 != $(n + 1) || $2 != $(n + 2)) { print "FAILED: other particles: " $0; exit bad = 1 }
    for (i = 3; i <= n; i++) {
      size = $i < 0 ? -$i : $i
      off = $i - $(i + n); if (off < 0) off = -off
      if (off > tolerance*size) { print "FAILED: differs: " $0; exit bad = 1 }
    }
  }
  END { exit bad }'
