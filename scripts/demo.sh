#!/usr/bin/env bash
# scripts/demo.sh [OUTPUT-FOLDER]: the main jobs on real data, from the input files to the picture.
# Kinetic Adhesion Test: 316L on UPVC and on glass (thesis): critical diameters by LIGGGHTS beside theory
# and measurement. The seven drop tests of Zafar et al. to the end: the model as it is against the
# measurements, diagnosis, the leading plausible effect added, LIGGGHTS again, report.
# Coupled job: powder in a pipe of 1.25 mm, its first 30 mm for 6 ms, LIGGGHTS and powderFoam in one mpirun.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
out=${1:-$root/results/demo}
bin=$root/build/bin
mkdir -p "$out"

studies=(pedrolli_316L_upvc pedrolli_316L_glass)
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

# The study is copied: what is added is written beside it.
drop=$out/zafar2014
mkdir -p "$drop"
cp "$root/kat_cases/zafar2014/study.toml" "$root/kat_cases/zafar2014/zafar2014_drop_test.csv" "$drop/"
printf '\n== drop tests of glass on glass: the model as it is\n'
"$bin/powderlink" compare "$drop/study.toml" --backend dem --out "$drop/runs_before" --json "$drop/before.json"
printf '\n== what is missing\n'
"$bin/powderlink" diagnose "$drop/study.toml" --json "$drop/diagnosis.json"
effect=$(sed -n 's/^ *"best": "\([^"]*\)".*/\1/p' "$drop/diagnosis.json")
if [[ -z $effect ]]; then
  echo "demo: diagnose named no effect for $drop/study.toml; see $drop/diagnosis.json" >&2
  exit 1
fi
printf '\n== with %s, LIGGGHTS again\n' "$effect"
"$bin/powderlink" add "$drop/study.toml" "$effect" -o "$drop/added.toml" --script "$drop/in.added"
"$bin/powderlink" compare "$drop/added.toml" --backend dem --out "$drop/runs_after" --json "$drop/after.json"
printf '\n== report\n'
"$bin/powderlink" report "$drop/study.toml" "$drop/added.toml" --diagnose-first \
  --dem "$drop/before.json" "$drop/after.json" -o "$out/report.html"

printf '\n== powder in a pipe, LIGGGHTS and OpenFOAM coupled\n'
"$root/foam_cases/pipe/run.sh" --short --out "$out/pipe"
"$bin/powderlink" flow "$out/pipe/case" --from 0.003 --from-z 0.01 --json "$out/pipe/flow.json"
"$bin/powderlink-render" flow "$out/pipe/case" -o "$out/pipe.png"
"$bin/powderlink-render" flow-series "$out/pipe/case" >/dev/null

cat <<TEXT

Report      $out/report.html, its figures in $out/report_figures/
Tables      $out/*/kat.csv, kat.json; $drop/before.json, after.json, diagnosis.json; $out/pipe/case/flow/*.csv
Figures     $out/*/critical_diameter.svg, $out/*/row_*/round_1/residual_velocity.svg
            $out/pipe/case/flow/*.svg
Pictures    $out/kat.png, $out/pipe.png
ParaView    paraview $picture/particles.pvd   (or scripts/paraview/kat_view.py)
            paraview $out/pipe/case/particles.pvd $out/pipe/case/case.foam   (or scripts/paraview/flow_view.py)
TEXT
