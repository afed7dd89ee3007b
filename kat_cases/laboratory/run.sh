#!/usr/bin/env bash
# From tables of grains to Gamma: kat analyse of six drops, then what their study lacks,
# and Gamma with it.
# run.sh [--short] [--out DIR]      --short changes nothing: it takes seconds
set -euo pipefail
cd "$(dirname "$0")"
. ../../scripts/case_results.sh
out=$PWD/results results=$PWD/results.json
while [[ $# -gt 0 ]]; do
  case $1 in
    -h | --help) case_usage; exit 0 ;;
    --short) shift ;;
    --out) out=$(case_path "${2:?--out DIR: add the folder}"); results=$out/results.json; shift 2 ;;
    *) echo "run.sh: unknown option; given: $1; allowed: --short, --out DIR; to do: correct it" >&2; exit 1 ;;
  esac
done
program=../../powderlink
if [[ -n ${POWDERLINK_BIN:-} ]]; then program=$POWDERLINK_BIN/powderlink; fi
rm -rf "$results" "$out"/drop_* "$out"/study*
mkdir -p "$out"
start=$(date +%s.%N)

# Of d_c: 450 grains, scatter of 8 %, give it to about 3 %; of Gamma from six drops twice that over sqrt(6).
tolerance_diameter=0.08
tolerance_gamma=0.08
number() { sed -n -E "/\"$2\"/,/}/s/^ *\"value\": *([-0-9.e+]+),?/\1/p" "$1" | head -n 1; }

for velocity in 0.7 1.0 1.4 2.0 2.8 4.0; do
  mkdir -p "$out/drop_$velocity"
  "$program" kat analyse --before "drops/before_$velocity.csv" --after "drops/after_$velocity.csv" \
    --pixel-size-um 0.5 --velocity "$velocity" --particle 316L --substrate UPVC \
    --contact-time-us 100 --contact-radii contact_radii.csv --study "$out/study.toml" \
    --out "$out/drop_$velocity" --json "$out/drop_$velocity/kat.json"
  case_result "critical_diameter_${velocity}m_s" um \
    "$(number "$out/drop_$velocity/kat.json" critical_diameter_um)" \
    "$(awk -v v="$velocity" 'BEGIN { print 46*sqrt(1.4/v) }')" "$tolerance_diameter" \
    "the truth of make_tables.sh"
done
"$program" diagnose "$out/study.toml" --json "$out/diagnose.json"
"$program" add "$out/study.toml" finite_stop_pulse -o "$out/study_stop.toml"
"$program" compare "$out/study_stop.toml" --json "$out/compare.json"
case_result adhesive_energy J/m^2 \
  "$(sed -n -E 's/^ *"adhesive_energy_J_m2": *([0-9.e+-]+),?/\1/p' "$out/compare.json" | head -n 1)" \
  0.0825 "$tolerance_gamma" "the truth of make_tables.sh; slow stop of 100 us"
end=$(date +%s.%N)
case_write laboratory "$results" "$(awk -v a="$start" -v b="$end" 'BEGIN { printf "%.3f", b - a }')" 1 \
  "\"powderlink\": \"$("$program" --version | sed 's/^powderlink //')\""
