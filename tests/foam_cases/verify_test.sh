#!/usr/bin/env bash
# verify_test.sh SCRIPTS WORK: the table, the JSON and the exit status of scripts/verify.sh, on three
# small cases: one good, one outside its tolerance, one that breaks off.
set -euo pipefail
scripts=$1 work=$2
rm -rf "$work"
mkdir -p "$work"/scripts "$work"/foam_cases/{good,outside,broken} "$work"/kat_cases
cp "$scripts"/{verify,case_results}.sh "$work/scripts/"
status=0
failed() { echo "FAILED: $*" >&2; status=1; }

new_case() {  # name, results
  cat >"$work/foam_cases/$1/run.sh" <<SCRIPT
#!/usr/bin/env bash
set -euo pipefail
cd "\$(dirname "\$0")"
. ../../scripts/case_results.sh
$2
case_write $1 results.json 1.5 2 '"openfoam": "1912"'
SCRIPT
  chmod +x "$work/foam_cases/$1/run.sh"
}
new_case good 'case_result drop Pa 22.9 23 0.01 "Ergun"; case_result closure 1 -1e-13 0 1e-10 "momentum"'
new_case outside 'case_result drop Pa 22 23 0.01 "Ergun"; case_result missing Pa "" 0 1 "nothing"; case_result closure 1 -1e-9 0 1e-10 "momentum"'
new_case broken 'exit 3'

verify() { code=0; "$work/scripts/verify.sh" "$@" >"$work/out" 2>"$work/err" || code=$?; }

verify good --json "$work/good.json"
[[ $code == 0 ]] || failed "a good case: exit status $code"
grep -qE '^good +drop +Pa +22.9 +23 +-0.435 % +1 % +yes$' "$work/out" || failed "its row"
grep -qE '^good +closure +- +-1e-13 +0 +-1e-13 +1e-10 +yes$' "$work/out" || failed "the row of a reference of 0"
grep -q '2 of 2 quantities of 1 cases' "$work/out" || failed "its sum"
grep -q '^{"pass": true, "short": false' "$work/good.json" || failed "its JSON"

verify outside
[[ $code == 1 ]] || failed "a quantity outside its tolerance: exit status $code"
[[ $(grep -c ' NO$' "$work/out") == 3 ]] || failed "values outside, missing and too large: $(cat "$work/out")"

verify --short --json "$work/all.json"
[[ $code == 1 ]] || failed "a case that breaks off: exit status $code"
grep -q '^broken .*did not run to its end.* NO$' "$work/out" || failed "the row of the broken case"
[[ $(grep -c '"case":' "$work/all.json") == 3 ]] || failed "all cases in the JSON"
grep -q '"error": "run.sh ended with status 3"' "$work/all.json" || failed "the error in the JSON"

# A relative path is meant where run.sh is called, not where the case is.
mkdir "$work/elsewhere" "$work/foam_cases/path"
new_case path 'case_path here/there'
path=$(cd "$work/elsewhere" && ../foam_cases/path/run.sh 2>/dev/null | head -n 1) || true
[[ $path == "$work/elsewhere/here/there" ]] || failed "relative path from elsewhere: $path"
rm -r "$work/foam_cases/path"

refused() {  # arguments; texts of the message
  verify $1
  shift
  [[ $code == 1 ]] || failed "accepted: exit status $code"
  for text in "given:" "allowed:" "to do:" "$@"; do
    grep -qF -- "$text" "$work/err" || failed "the message lacks '$text'"
  done
}
refused settling "unknown case" settling "broken good outside"
refused --fast "unknown option" --fast
refused "--json $work/no/such.json" "no such folder"
refused "--docs good" "all cases in full"
exit $status
