#!/usr/bin/env bash
# scripts/demo.sh [OUTPUT-FOLDER]: the Kinetic Adhesion Test on real data, from study to picture.
# 316L on UPVC and on glass (thesis), the seven drop tests of Zafar et al. with an instant and with a
# 100 us stop: critical diameters by LIGGGHTS beside theory and measurement.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
out=${1:-$root/results/demo}
bin=$root/build/bin
mkdir -p "$out"

studies=(pedrolli_316L_upvc pedrolli_316L_glass zafar2014 half_sine_glass)
for study in "${studies[@]}"; do
  printf '\n== %s\n' "$study"
  "$bin/powderlink" kat run "$root/kat_cases/$study/study.toml" \
    --out "$out/$study" --json "$out/$study/kat.json"
done

printf '\n== figures and pictures\n'
for study in "${studies[@]}"; do
  "$root/scripts/plots/plot.sh" "$out/$study" >/dev/null
done
# The first round of a row has grains from well below to well above the critical diameter.
picture=$out/pedrolli_316L_upvc/row_01/round_1
"$bin/powderlink-render" png "$picture" -o "$out/kat.png"
"$bin/powderlink-render" series "$picture" >/dev/null

cat <<TEXT

Tables      $out/*/kat.csv, kat.json
Figures     $out/*/critical_diameter.svg, $out/*/row_*/round_1/residual_velocity.svg
Picture     $out/kat.png
ParaView    paraview $picture/particles.pvd   (or scripts/paraview/kat_view.py)
TEXT
