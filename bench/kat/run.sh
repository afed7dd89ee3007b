#!/usr/bin/env bash
# bench/kat/run.sh LAUNCHER: wall time of a whole KAT of 2 000 and of 10 000 grains on one core.
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
launcher=$(realpath "${1:?launcher: build/bin/liggghts-powderlink}")
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"
printf "%-10s %12s %12s %14s\n" grains "wall s" "limit s" "d_c um"
for row in "2000 20" "10000 90"; do
  read -r n limit <<<"$row"
  start=$(date +%s.%N)
  timeout 600 "$launcher" -in "$here/in.kat" -var n "$n" > out.txt 2>&1 || { tail -5 out.txt >&2; exit 1; }
  end=$(date +%s.%N)
  diameter=$(sed -n 's/.*"critical_diameter_m": \([0-9.e-]*\).*/\1/p' kat.json)
  awk -v n="$n" -v a="$start" -v b="$end" -v l="$limit" -v d="$diameter" \
    'BEGIN { printf "%-10d %12.1f %12d %14.2f\n", n, b - a, l, d * 1e6 }'
done
