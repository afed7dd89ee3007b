#!/usr/bin/env bash
# sensitivity_test.sh SOURCE WORK: foam_cases/pipe/sensitivity.sh in its short form. It is killed while its
# last run is under way and called again: what has ended is kept, the rest is run, and the table has it.
# Runs differ by what was moved, and by nothing else.
set -euo pipefail
case=$1/foam_cases/pipe out=$2/sensitivity limit_s=150
fail() {
  echo "sensitivity_test: $*" >&2
  exit 1
}
rm -rf "$out"
mkdir -p "$out"
# Called without a function around it, so that a job is the script itself.
sensitivity=("$case/sensitivity.sh" --short --only friction,all --out "$out/table")

# One at a time: base, friction, all.
"${sensitivity[@]}" --jobs 1 >"$out/log.first" 2>&1 &
job=$! begin=$SECONDS
trap 'kill $job 2>/dev/null || true' EXIT
until [[ -f $out/table/all/case/post/restart.3000 ]]; do
  kill -0 $job 2>/dev/null || fail "ended before it was killed: $(tail -n 3 "$out/log.first")"
  ((SECONDS < begin + limit_s)) || fail "no checkpoint of the last run within $limit_s s"
  sleep 0.05
done
kill -TERM $job
code=0
wait $job || code=$?
[[ $code == 130 ]] || fail "status $code after a signal"
[[ ! -e $out/table/sensitivity.csv ]] || fail "a table of runs that have not ended"
kept=$(stat -c %y "$out"/table/{base,friction}/results.json "$out"/table/{base,friction}/observed.csv)

# Another set of runs has no place beside them.
code=0
"${sensitivity[@]}" --base source >"$out/refused" 2>&1 || code=$?
[[ $code == 1 ]] && grep -q 'the folder holds runs of other options; given: .*; allowed: .*; to do: ' "$out/refused" ||
  fail "runs of another base in one folder"

timeout $limit_s "${sensitivity[@]}" >"$out/log.second" 2>&1 ||
  fail "second call: $(tail -n 3 "$out/log.second")"
[[ $kept == "$(stat -c %y "$out"/table/{base,friction}/results.json "$out"/table/{base,friction}/observed.csv)" ]] ||
  fail "a run that had ended was run again"
# run.sh --continue leaves it.
[[ -f $out/table/all/case/restart.json ]] || fail "the run that was killed began anew"

cd "$out/table"
[[ $(awk -F, '!/^#/ && $1 != "run" { printf "%s ", $1 }' sensitivity.csv) == "assumed friction source " ]] ||
  fail "rows: $(cat sensitivity.csv)"
# Grains of the table are those of the run's own counts, to the change within its dumps.
awk -F, '
  FILENAME == "sensitivity.csv" { if ($1 == "friction") grains = $5; next }
  FNR > 1 && $1 > 0.003 - 1e-9 { sum += $3; n++ }
  END { mean = sum/n; exit !(mean > 100 && (grains/mean - 1)^2 < 0.01^2) }' sensitivity.csv friction/case/post/particle_count.csv ||
  fail "grains of the table"
[[ $(diff base/case/in.inputs friction/case/in.inputs | awk '/^[<>]/ { print $3, $5 }' | xargs) == "friction 0.3 friction 0.52" ]] ||
  fail "friction alone: $(diff base/case/in.inputs friction/case/in.inputs)"
cmp base/case/in.powder friction/case/in.powder || fail "powder"
grep -q 'friction: 0.3 -> 0.52' sensitivity.txt || fail "text: $(cat sensitivity.txt)"
grep -q '</svg>' sensitivity.svg || fail "no figure"
[[ -z $(find . -name 'particles_*.dump' -print -quit) ]] || fail "dumps are left"
