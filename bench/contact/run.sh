#!/usr/bin/env bash
# bench/contact/run.sh: ns per particle and step of jkr against stock hertz (and LAMMPS's granular JKR),
# in turn in one run, so that the ratios hold when the machine's speed drifts.
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
launcher=$(realpath "${1:?launcher: build/bin/liggghts-powderlink}")
repeats=${2:-5}
steps=2000
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cp "$here"/in.* "$here"/wall_* "$work"
"$here"/make_plate.sh "$work/plate.stl"
cd "$work"

# The last loop time of LIGGGHTS or LAMMPS, in ns per particle and step.
cost() {
  timeout 300 "$@" > out.txt 2>&1 || { tail -5 out.txt >&2; exit 1; }
  awk -v steps=$steps '/^Loop time of/ { t = $4 } END { printf "%.1f\n", t / steps / 10000 * 1e9 }' out.txt
}
liggghts_cost() { cost "$launcher" -in in.liggghts -var model "$1" -var wall "$2" -var steps $steps; }

for ((i = 0; i < repeats; i++)); do
  for wall in primitive mesh; do
    for model in hertz jkr; do
      ns=$(liggghts_cost $model $wall)
      echo "$model $wall $ns"
    done
  done
  if command -v lmp >/dev/null; then
    ns=$(cost lmp -in in.lammps -var steps $steps)
    echo "lammps_jkr primitive $ns"
  fi
done | awk '
  function median(list, n,   a, i, j, t) {
    split(list, a, " ")
    for (i = 1; i <= n; i++) for (j = i + 1; j <= n; j++) if (a[j] < a[i]) { t = a[i]; a[i] = a[j]; a[j] = t }
    return n % 2 ? a[(n + 1) / 2] : (a[n / 2] + a[n / 2 + 1]) / 2
  }
  { key = $1 " " $2; list[key] = list[key] $3 " "; n[key]++
    if ($1 == "hertz") base[$2] = $3; else { r = key; ratio[r] = ratio[r] $3 / base[$2] " "; nr[r]++ } }
  END {
    printf "%-12s %-10s %22s %26s\n", "model", "wall", "ns/particle-step", "ratio to stock hertz"
    for (w = 1; w <= 2; w++) { wall = w == 1 ? "primitive" : "mesh"
      for (m = 1; m <= 3; m++) { model = m == 1 ? "hertz" : m == 2 ? "jkr" : "lammps_jkr"; key = model " " wall
        if (!(key in n)) continue
        printf "%-12s %-10s %22.1f %26s\n", model, wall, median(list[key], n[key]), \
          (key in nr) ? sprintf("%.2f", median(ratio[key], nr[key])) : "1" } } }'
