#!/usr/bin/env bash
# scripts/verify.sh [CASE...] [--short] [--json FILE] [--out DIR] [--docs]
# Runs the cases of foam_cases/ and kat_cases/ (default: all) and prints one table of their results.
#   --short      the short form of every case
#   --json FILE  all results: {"pass", "short", "cases": [results.json of each case]}
#   --out DIR    runs in DIR/CASE instead of the folder of the case
#   --docs       writes the table into docs/verification.md; needs all cases in full
# Exit status 1 when a case fails or a quantity is outside its tolerance.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
page=$root/docs/verification.md

fail() {  # what failed; what was given; what is allowed; what to do
  printf 'verify: %s; given: %s; allowed: %s; to do: %s\n' "$@" >&2
  exit 1
}

known=()
for script in "$root"/foam_cases/*/run.sh "$root"/kat_cases/*/run.sh; do
  if [[ -x $script ]]; then known+=("$(basename "$(dirname "$script")")"); fi
done

cases=() options=() json= out= docs=no short=false
while [[ $# -gt 0 ]]; do
  case $1 in
    -h | --help) sed -n '2,8s/^# //p' "${BASH_SOURCE[0]}"; exit 0 ;;
    --short) short=true; options+=(--short); shift ;;
    --docs) docs=yes; shift ;;
    --json | --out)
      [[ $# -ge 2 ]] || fail "option without a value" "$1" "$1 VALUE" "add the value"
      if [[ $1 == --json ]]; then json=$(realpath -m -- "$2"); else out=$(realpath -m -- "$2"); fi
      shift 2 ;;
    -*) fail "unknown option" "$1" "--short, --json FILE, --out DIR, --docs" "correct it" ;;
    *)
      [[ " ${known[*]} " == *" $1 "* ]] ||
        fail "unknown case" "$1" "${known[*]}" "correct the name"
      cases+=("$1"); shift ;;
  esac
done
if [[ $docs == yes && ( $short == true || ${#cases[@]} -gt 0 ) ]]; then
  fail "the table of the documentation" "--docs with --short or with single cases" \
    "all cases in full" "scripts/verify.sh --docs"
fi
if [[ -n $json && ! -d $(dirname "$json") ]]; then
  fail "no such folder" "$json" "a file in a folder that exists" "correct --json"
fi
if [[ ${#cases[@]} -eq 0 ]]; then cases=("${known[@]}"); fi

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
status=0
: >"$work/rows"

# Rows, tab separated: case, quantity, unit, value, reference, tolerance, pass. One quantity per line
# of results.json, as case_results.sh writes it.
rows_of() {
  awk -v name="$2" '
    function text(key) { return match($0, "\"" key "\": \"[^\"]*\"") ? part(key, 5, 1) : "" }
    function number(key) { return match($0, "\"" key "\": [^,}]*") ? part(key, 4, 0) : "" }
    function part(key, skip, quote) {
      return substr($0, RSTART + length(key) + skip, RLENGTH - length(key) - skip - quote)
    }
    /"tolerance":/ {
      printf "%s\t%s\t%s\t%s\t%s\t%s\t%s\n", name, text("name"), text("unit"), number("value"), \
        number("reference"), number("tolerance"), number("pass")
    }' "$1"
}

number=0
for name in "${cases[@]}"; do
  number=$((number + 1))
  folder=$root/foam_cases/$name
  if [[ ! -d $folder ]]; then folder=$root/kat_cases/$name; fi
  results=$folder/results.json
  here=()
  if [[ -n $out ]]; then
    results=$out/$name/results.json
    here=(--out "$out/$name")
  fi
  printf '[%d/%d] %s ' "$number" "${#cases[@]}" "$name" >&2
  start=$SECONDS
  rm -f "$results"
  code=0
  "$folder/run.sh" "${options[@]}" "${here[@]}" >"$work/log" 2>&1 || code=$?
  printf '%d s%s\n' $((SECONDS - start)) "$([[ $code == 0 ]] || echo ', failed')" >&2
  if [[ $code -ne 0 ]]; then status=1; fi
  if [[ -f $results ]]; then
    rows_of "$results" "$name" >>"$work/rows"
    sed '1!s/^/  /' "$results" >"$work/result.$number"
  else
    tail -n 30 "$work/log" >&2
    printf '%s\t%s\t\t\t\t\tfalse\n' "$name" "(did not run to its end)" >>"$work/rows"
    printf '{"case": "%s", "quantities": [], "error": "run.sh ended with status %d"}\n' "$name" "$code" \
      >"$work/result.$number"
  fi
done
if cut -f 7 "$work/rows" | grep -qv true; then status=1; fi

# One table, for the screen or with bars for Markdown.
table() {
  awk -F '\t' -v style="$1" '
    function add(i, text) { cell[n, i] = text; if (length(text) > width[i]) width[i] = length(text) }
    function short_number(x) { return x == "null" || x == "" ? x : sprintf("%.5g", x) }
    BEGIN {
      n = 0; split("case quantity unit value reference error tolerance pass", head, " ")
      for (i = 1; i <= 8; i++) add(i, head[i])
    }
    {
      n++
      add(1, $1); add(2, $2); add(3, $3 == "1" ? "-" : $3); add(4, short_number($4)); add(5, short_number($5))
      if ($4 != "null" && $4 != "") {
        relative = $5 != 0
        add(6, relative ? sprintf("%+.3f %%", 100*($4 - $5)/($5 < 0 ? -$5 : $5)) : sprintf("%+.2g", $4))
        add(7, relative ? sprintf("%.3g %%", 100*$6) : sprintf("%.2g", $6))
      } else { add(6, ""); add(7, "") }
      add(8, $7 == "true" ? "yes" : "NO")
    }
    END {
      bar = style == "markdown"
      for (r = 0; r <= n; r++) {
        line = ""
        for (i = 1; i <= 8; i++) {
          format = (i >= 4 && i <= 7) ? "%" width[i] "s" : "%-" width[i] "s"
          line = line (bar ? "| " : (i > 1 ? "  " : "")) sprintf(format, cell[r, i]) (bar ? " " : "")
        }
        if (!bar) sub(/ +$/, "", line)
        print line (bar ? "|" : "")
        if (r == 0) {
          line = ""
          for (i = 1; i <= 8; i++) {
            rule = sprintf("%" width[i] "s", ""); gsub(/ /, "-", rule)
            if (bar && i >= 4 && i <= 7) sub(/-$/, ":", rule)
            line = line (bar ? "| " : (i > 1 ? "  " : "")) rule (bar ? " " : "")
          }
          print line (bar ? "|" : "")
        }
      }
    }' "$work/rows"
}
table screen
echo
printf '%d of %d quantities of %d cases are within their tolerance\n' \
  "$(cut -f 7 "$work/rows" | grep -c true || true)" "$(wc -l <"$work/rows")" "${#cases[@]}"

if [[ -n $json ]]; then
  {
    printf '{"pass": %s, "short": %s, "cases": [\n' "$([[ $status == 0 ]] && echo true || echo false)" "$short"
    for ((i = 1; i <= number; i++)); do
      cat "$work/result.$i"
      if ((i < number)); then echo ,; fi
    done
    printf ']}\n'
  } >"$json.part"
  mv "$json.part" "$json"
fi

if [[ $docs == yes ]]; then
  [[ $status == 0 ]] || fail "the table was not written" "failed cases" "cases that pass" "see above"
  for marker in '<!-- verification:begin -->' '<!-- verification:end -->'; do
    [[ $(grep -cxF -- "$marker" "$page") -eq 1 ]] ||
      fail "a marker of the table" "docs/verification.md" "one line '$marker'" "put the line back"
  done
  table markdown >"$work/table.md"
  awk -v table="$work/table.md" '
    $0 == "<!-- verification:end -->" { inside = 0 }
    !inside { print }
    $0 == "<!-- verification:begin -->" {
      inside = 1
      while ((getline line < table) > 0) print line
    }' "$page" >"$page.part"
  mv "$page.part" "$page"
  echo "docs/verification.md: table written"
fi
exit $status
