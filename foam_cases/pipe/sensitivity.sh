#!/usr/bin/env bash
# Which input moves what: case A from the filled state, each input alone moved from the assumed value to
# that of the source, and all of them.
# sensitivity.sh [--short] [--base assumed|source] [--case A|B] [--only NAME,...] [--end-time T] [--jobs N]
#                [--out DIR]
#   --base source   from the source's values to the assumed ones
#   --only          some of: injection friction slider modulus restitution forces points powder all
#   --jobs          runs at a time, each with one rank of either program (default: processors)
#   --end-time      0.15 s unless given; the last third is measured (observe.sh)
# Called again it keeps what has ended and goes on with what has not. DIR (default
# results/sensitivity_BASE) gets sensitivity.csv, .txt and .svg, and a folder for each run.
set -euo pipefail
cd "$(dirname "$0")"
caller=${OLDPWD:-$PWD}
. ../../scripts/foam_case.sh
. ./inputs.sh

# name of a row: its inputs, the first one for the table
moves='injection:inletOverGas friction:friction slider:tangential,sliderStep modulus:youngsModulus restitution:restitution
  forces:forces,model points:diskDiameter,pitch
  powder:meanMass,density,sizeLaw,sizeOrigin,sizeExponent,sizeScale all:'
short=no base=assumed flow=A only='' end_time='' jobs=$(nproc) out=''
while [[ $# -gt 0 ]]; do
  case $1 in
    -h | --help) case_usage; exit 0 ;;
    --short) short=yes; shift ;;
    --base | --case | --only | --end-time | --jobs | --out)
      [[ $# -ge 2 ]] || foam_case_fail "option without a value" "$1" "$1 VALUE" "add the value"
      case $1 in
        --base) base=$2 ;;
        --case) flow=$2 ;;
        --only) only=$2 ;;
        --end-time) end_time=$2 ;;
        --jobs) jobs=$2 ;;
        --out) out=$(cd "$caller" && realpath -m -- "$2") ;;
      esac
      shift 2 ;;
    *) foam_case_fail "unknown option" "$1" \
      "--short, --base, --case, --only, --end-time, --jobs, --out" "correct it" ;;
  esac
done
case $base in
  assumed) other=source ;;
  source) other=assumed ;;
  *) foam_case_fail "unknown inputs" "$base" "assumed, source" "correct --base" ;;
esac
[[ $flow == A || $flow == B ]] || foam_case_fail "unknown case" "$flow" "A, B" "correct --case"
[[ $jobs =~ ^[1-9][0-9]*$ ]] || foam_case_fail "bad number of jobs" "$jobs" "an integer, at least 1" \
  "correct --jobs"
[[ -z $end_time || $end_time =~ ^[0-9.]+(e-?[0-9]+)?$ ]] ||
  foam_case_fail "bad time" "$end_time" "seconds" "correct --end-time"
for program in powderFoam liggghts-powderlink powderlink; do foam_case_need "$program"; done
out=${out:-$PWD/results/sensitivity_$base}
form=(--filled) place=0.2 window=0.002 checkpoint=0.01
if [[ $short == yes ]]; then form=(--short) place=0.02 window=0.001 checkpoint=0.0015; fi
end_time=${end_time:-$([[ $short == yes ]] && echo 0.0045 || echo 0.15)}
from=$(awk "BEGIN { printf \"%.6g\", 2*$end_time/3 }")

names=()
for move in $moves; do names+=("${move%%:*}"); done
for name in ${only//,/ }; do
  [[ " ${names[*]} " == *" $name "* ]] || foam_case_fail "unknown row" "$name" "${names[*]}" "correct --only"
done
chosen() { [[ -z $only || ,$only, == *",$1,"* ]]; }

mkdir -p "$out"
exec 9>"$out/.lock"
flock --nonblock 9 || foam_case_fail "another sensitivity.sh is at work" "$out" "one in a folder" \
  "wait for it, or give another --out"

# Inputs of both ends.
powder=$(mktemp)
pids=()
# A job is a group of processes of its own.
finish() {
  local pid
  rm -f "$powder"
  for pid in ${pids[@]+"${pids[@]}"}; do kill -TERM -- "-$pid" 2>/dev/null || true; done
  wait || true
  # The lock is that of all that a job has started, too: whoever comes next finds it free.
  exec 9>&-
  flock --timeout "$foam_case_programs_end_s" "$out/.lock" true || true
}
trap finish EXIT
trap 'exit 130' INT TERM
declare -A base_value=() other_value=()
pipe_inputs_read "inputs/$base"
pipe_inputs_derive "$flow" "$powder"
for name in "${!input[@]}"; do base_value[$name]=${input[$name]}; done
pipe_inputs_read "inputs/$other"
pipe_inputs_derive "$flow" "$powder"
for name in "${!input[@]}"; do other_value[$name]=${input[$name]}; done

# What a run is called with, words one a line.
arguments() {  # row
  local name
  printf '%s\n' "${form[@]}" --case "$flow" --end-time "$end_time" --write-interval "$checkpoint"
  if [[ $1 == all ]]; then
    printf '%s\n' --inputs "$other"
    return
  fi
  printf '%s\n' --inputs "$base"
  for move in $moves; do
    [[ ${move%%:*} == "$1" ]] || continue
    for name in $(tr , ' ' <<<"${move#*:}"); do
      [[ -z ${other_value[$name]:-} || ${other_value[$name]} == "${base_value[$name]:-}" ]] ||
        printf '%s\n' --set "$name=${other_value[$name]}"
    done
  done
}

# One run to its end, from its last checkpoint where it has one.
run_row() {  # row
  local folder=$out/$1 given go_on=() dt
  mapfile -t given < <(arguments "$1")
  mkdir -p "$folder"
  if [[ ! -f $folder/results.json ]]; then
    if [[ -f $folder/case/in.inputs ]]; then
      dt=$(awk '$2 == "dt" { gsub(/"/, ""); print $4 }' "$folder/case/in.inputs")
      if "$foam_case_bin/powderlink" restart "$folder/case" --dt "$dt" >"$folder/log.restart" 2>&1; then
        go_on=(--continue --end-time "$end_time" --write-interval "$checkpoint")
        if [[ $short == yes ]]; then go_on+=(--short); fi
      fi
    fi
    if [[ ${#go_on[@]} -gt 0 ]]; then given=("${go_on[@]}"); fi
    # Status 1 with results: a quantity outside its tolerance, which the table tells.
    ./run.sh "${given[@]}" --out "$folder" >"$folder/log" 2>&1 || true
  fi
  [[ -f $folder/results.json ]] || { tail -n 5 "$folder/log" >&2; return 1; }
  ./observe.sh "$folder/case" "$from" "$place" "$window" "$foam_case_bin/powderlink" >"$folder/observed.part"
  mv "$folder/observed.part" "$folder/observed.csv"
  # Half a gigabyte in each run of 0.15 s.
  find "$folder/case/post" -name 'particles_*.dump' -delete
}

rows=()
for row in base "${names[@]}"; do
  if [[ $row != base ]] && ! chosen "$row"; then continue; fi
  rows+=("$row")
  # What has been run with other options would stand in the table under a wrong name.
  if [[ -f $out/$row/arguments ]] && ! cmp -s "$out/$row/arguments" <(arguments "$row"); then
    foam_case_fail "the folder holds runs of other options" \
      "$out/$row: $(xargs <"$out/$row/arguments")" "$(arguments "$row" | xargs)" "give another --out"
  fi
done
set -m
status=0 done_rows=0 begin=$SECONDS
await() {  # the end of one job
  local ended pid code=0 left=()
  wait -n -p ended || code=$?
  for pid in "${pids[@]}"; do [[ $pid == "$ended" ]] || left+=("$pid"); done
  pids=(${left[@]+"${left[@]}"})
  if ((code != 0)); then status=1; fi
  done_rows=$((done_rows + 1))
  echo "$done_rows of ${#rows[@]} runs, $((SECONDS - begin)) s" >&2
}
for row in "${rows[@]}"; do
  if [[ -f $out/$row/observed.csv ]]; then
    done_rows=$((done_rows + 1))
    continue
  fi
  mkdir -p "$out/$row"
  arguments "$row" >"$out/$row/arguments"
  while ((${#pids[@]} >= jobs)); do await; done
  echo "$row: $(arguments "$row" | grep -A 1 -e --set -e --inputs | grep -v -e '^--' | xargs)" >&2
  # The lock is theirs, too: until they have ended, when this script is killed.
  run_row "$row" &
  pids+=($!)
done
while ((${#pids[@]} > 0)); do await; done
set +m
[[ $status == 0 ]] || foam_case_fail "a run did not end" "see above, and $out/*/log" \
  "runs with results" "cure it and call again: what has ended is kept"

# The table: rows of the runs, then what the source prints.
shown() {  # value of an input by the row's first name, which may be on one side only
  case $1 in
    meanMass) echo grainMass ;;
    inletOverGas) echo inletSpeed ;;
    *) echo "$1" ;;
  esac
}
{
  echo "# case $flow from the filled state, $from to $end_time s, beyond $place m, rms after $window s; +-: see observe.sh; printed: slope times density"
  echo "run,input,from,to,grains,grains_half,velocity_m_s,velocity_half,velocity_std_m_s,slope_Pa_m,slope_half,rms_percent,rms_half,front_m,passed"
  for row in "${rows[@]}"; do
    first=
    for move in $moves; do
      if [[ ${move%%:*} == "$row" ]]; then first=${move#*:} first=${first%%,*}; fi
    done
    a='' b=''
    if [[ -n $first ]]; then
      first=$(shown "$first")
      a=${base_value[$first]} b=${other_value[$first]}
    fi
    passed=$(grep -q '"pass": false' "$out/$row/results.json" && echo no || echo yes)
    label=$row
    if [[ $row == base ]]; then label=$base; elif [[ $row == all ]]; then label=$other; fi
    echo "$label,$first,$a,$b,$(<"$out/$row/observed.csv"),$passed"
  done
  # Of the whole pipe.
  [[ $short == yes ]] || awk -F, -v flow="$flow" '$1 == flow && $2 == "CFD-DEM" {
    printf "printed,,,,%s,,%s,,%s,%g,,%.3g,,,\n", $3, $4, $5, 1.6355*$6, 100*$8/$7 }' source_results.csv
} >"$out/sensitivity.csv.part"
mv "$out/sensitivity.csv.part" "$out/sensitivity.csv"

awk -F, -v OFS= '
  function value(x, half, digits) {
    if (x == "" || x == "-") return "-"
    return sprintf("%." digits "f", x) (half == "" || half == "-" ? "" : sprintf(" +- %." digits "f", half))
  }
  /^#/ { print substr($0, 3); next }
  !head { head = 1; format = "%-12s %-42s %14s %16s %7s %17s %13s %8s %s\n"
    printf format, "run", "input", "grains", "velocity [m/s]", "spread", "slope [Pa/m]", "rms [%]", "front [m]", "passed"; next }
  { what = $2 == "" ? "" : $2 == "forces" ? "drag and weight only, or all" : $2 ": " $3 " -> " $4
    printf format, $1, what, value($5, $6, 0), value($7, $8, 2), value($9, "", 2), value($10, $11, 0),
      value($12, $13, 1), value($14, "", 3), $15 }' "$out/sensitivity.csv" >"$out/sensitivity.txt"
cat "$out/sensitivity.txt"

# Of the figure: name, then value and half an interval of four quantities; their extremes.
extremes=$(awk -F, -v table="$out/figure.part" '
  function take(k, value, half) {
    if (value !~ /[0-9]/) return " -1 0"  # outside of its axis
    half += 0
    if (!(k in low) || value - half < low[k]) low[k] = value - half
    if (!(k in high) || value + half > high[k]) high[k] = value + half
    return " " value " " half
  }
  function four(x,  k, text) { for (k = 1; k <= 4; k++) text = text " " (k in x ? x[k] : "NaN"); return text }
  BEGIN { split("5 7 10 12", at, " ") }
  /^#/ || $1 == "run" { next }
  {
    line = $1
    for (k = 1; k <= 4; k++) line = line take(k, $at[k], $(at[k] + 1))
    if ($1 == "printed") for (k = 1; k <= 4; k++) { if ($at[k] ~ /[0-9]/) printed[k] = $at[k] }
    else { print line >table; names = names " " $1 }
  }
  END { printf "names=\"%s\"; printed=\"%s\"; lowest=\"%s\"; highest=\"%s\"", names, four(printed), four(low), four(high) }' \
  "$out/sensitivity.csv")
plots=../../scripts/plots
gnuplot -e "table='$out/figure.part'; output='$out/sensitivity.svg.part'; rows=${#rows[@]}; $extremes; load '$plots/style.gp'" \
  sensitivity.gp 2>"$out/log.gnuplot" || foam_case_fail "drawing $out/sensitivity.svg" \
  "$(tail -n 3 "$out/log.gnuplot" | xargs)" "gnuplot 5.4 or later" "see $out/log.gnuplot"
rm "$out/figure.part"
mv "$out/sensitivity.svg.part" "$out/sensitivity.svg"
echo "$out/sensitivity.csv, .txt, .svg"
