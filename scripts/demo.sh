#!/usr/bin/env bash
# scripts/demo.sh [OUTPUT-FOLDER]: the main jobs on real data, from the input files to the picture.
# Kinetic Adhesion Test: 316L on UPVC and on glass (thesis), the seven drop tests of Zafar et al. with
# an instant and with a 100 us stop: critical diameters by LIGGGHTS beside theory and measurement.
# Coupled job: powder in a pipe of 1.25 mm, its first 30 mm for 6 ms, LIGGGHTS and powderFoam in one mpirun.
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

printf '\n== powder in a pipe, LIGGGHTS and OpenFOAM coupled\n'
"$root/foam_cases/pipe/run.sh" --short --out "$out/pipe"
"$bin/powderlink" flow "$out/pipe/case" --from 0.003 --from-z 0.01 --json "$out/pipe/flow.json"
"$bin/powderlink-render" flow "$out/pipe/case" -o "$out/pipe.png"
"$bin/powderlink-render" flow-series "$out/pipe/case" >/dev/null

cat <<TEXT

Tables      $out/*/kat.csv, kat.json; $out/pipe/case/flow/*.csv
Figures     $out/*/critical_diameter.svg, $out/*/row_*/round_1/residual_velocity.svg
            $out/pipe/case/flow/*.svg
Pictures    $out/kat.png, $out/pipe.png
ParaView    paraview $picture/particles.pvd   (or scripts/paraview/kat_view.py)
            paraview $out/pipe/case/particles.pvd $out/pipe/case/case.foam   (or scripts/paraview/flow_view.py)
TEXT
