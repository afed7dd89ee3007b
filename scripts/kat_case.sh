#!/usr/bin/env bash
# Common part of kat_cases/*/run.sh; sourced, in the folder of the case:
#   kat_case CASE "$@"   [--short] [--out DIR] and the options of `powderlink kat run`; runs study.toml
#                        and writes results.json: d_c with LIGGGHTS against the closed form. A study
#                        takes seconds, so --short changes nothing.
# The program is taken from POWDERLINK_BIN, else built and run by the entry script.

kat_case_root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
. "$kat_case_root/scripts/case_results.sh"
# Largest difference seen 0.05 %; the closed forms for a slow stop hold to 0.1 %.
kat_case_tolerance=0.003

kat_case() {
  local name=$1 out=$PWD/results results=$PWD/results.json options=() start end
  local program=$kat_case_root/powderlink
  shift
  while [[ $# -gt 0 ]]; do
    case $1 in
      -h | --help) case_usage; exit 0 ;;
      --short) shift ;;
      --out)
        out=$(case_path "${2:?--out DIR: add the folder}")
        results=$out/results.json
        shift 2 ;;
      *) options+=("$1"); shift ;;
    esac
  done
  if [[ -n ${POWDERLINK_BIN:-} ]]; then program=$POWDERLINK_BIN/powderlink; fi
  # kat run reuses finished rows; a verification must not.
  rm -rf "$results" "$out"/row_* "$out"/kat.csv
  mkdir -p "$out"
  start=$(date +%s.%N)
  "$program" kat run study.toml --out "$out" --json "$out/kat.json" "${options[@]}"
  end=$(date +%s.%N)

  local velocity theory value liggghts
  while IFS=, read -r velocity _ theory _ value _; do
    case_result "critical_diameter_${velocity}m_s" um "$value" "$theory" "$kat_case_tolerance" \
      "closed form of the stop with the study's adhesive energy (powderlink kat theory)"
  done < <(grep -v -e '^#' -e '^impact' "$out/kat.csv")
  liggghts=$(sed -n -E 's/^LIGGGHTS \(Version ([^,]*),.*/\1/p' "$out"/row_*/round_*/log.liggghts |
    sort -u | head -n 1)
  case_write "$name" "$results" "$(awk -v a="$start" -v b="$end" 'BEGIN { printf "%.3f", b - a }')" 1 \
    "\"liggghts\": \"$liggghts\""
}
