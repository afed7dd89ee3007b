#!/usr/bin/env bash
# scripts/update_docs.sh [--check] [PROGRAM]: writes the table of effects in docs/reference.md from
# the registry (`powderlink effects --json`). --check changes nothing and fails when it is stale.
# PROGRAM: the powderlink program, default build/bin/powderlink.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
page=$root/docs/reference.md

fail() {  # what failed; what was given; what is allowed; what to do
  printf 'update_docs: %s; given: %s; allowed: %s; to do: %s\n' "$@" >&2
  exit 1
}

check=no
if [[ ${1:-} == --check ]]; then
  check=yes
  shift
fi
program=${1:-$root/build/bin/powderlink}
[[ -x $program ]] || fail "the powderlink program is missing" "$program" "a program that can be run" \
  "build it (./powderlink effects), or name it as argument"
for marker in '<!-- effects:begin -->' '<!-- effects:end -->'; do
  [[ $(grep -cxF -- "$marker" "$page") -eq 1 ]] ||
    fail "a marker of the table" "docs/reference.md" "one line '$marker'" "put the line back"
done

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
"$program" effects --json "$work/effects.json" >/dev/null

# The JSON has one key per line, so the depth of the braces tells effects from their parameters.
awk '
  function value(line) {
    sub(/^[^:]*: */, "", line)
    sub(/,$/, "", line)
    gsub(/^"|"$/, "", line)
    gsub(/\\"/, "\"", line)
    gsub(/\|/, "\\|", line)
    return line
  }
  function range(low, high) { return low " .. " high }
  function flush_parameter() {
    if (!("name" in p)) return
    rows = rows sprintf("| `%s` | `%s` | %s | %s | %s | %s | %s | %s |\n", effect, p["name"], p["unit"], \
      p["off"], p["typical"], range(p["lower"], p["upper"]), \
      range(p["plausible_lower"], p["plausible_upper"]), p["source"])
    split("", p)
  }
  {
    opened = gsub(/\{/, "{")
    closed = gsub(/\}/, "}")
    depth += opened
    if (match($0, /"[a-z_]+":/)) {
      key = substr($0, RSTART + 1, RLENGTH - 3)
      if (depth == 2 && key == "name") effect = value($0)
      if (depth == 2 && key == "mechanism") mechanism = value($0)
      if (depth == 2 && key == "signature")
        list = list sprintf("| `%s` | %s | %s |\n", effect, mechanism, value($0))
      if (depth == 3) p[key] = value($0)
    }
    if (closed && depth == 3) flush_parameter()
    depth -= closed
  }
  END {
    if (rows == "" || list == "") exit 1
    printf "| effect | mechanism | signature in d_c(v) |\n|---|---|---|\n%s\n", list
    printf "| effect | parameter, in this order | unit | off | typical | bounds | plausible | source of the plausible range |\n"
    printf "|---|---|---|---|---|---|---|---|\n%s", rows
  }' "$work/effects.json" >"$work/table.md" ||
  fail "reading the list of effects" "output of $program effects --json" \
    "the JSON of this version" "build the program again"

awk -v table="$work/table.md" '
  $0 == "<!-- effects:end -->" { inside = 0 }
  !inside { print }
  $0 == "<!-- effects:begin -->" {
    inside = 1
    while ((getline line < table) > 0) print line
  }' "$page" >"$work/page.md"

if cmp -s "$work/page.md" "$page"; then exit 0; fi
if [[ $check == yes ]]; then
  diff -u --label docs/reference.md --label "from the registry" "$page" "$work/page.md" >&2 || true
  fail "the table of effects is stale" "docs/reference.md" "the table of the registry" \
    "scripts/update_docs.sh"
fi
cp "$work/page.md" "$page.part"
mv "$page.part" "$page"
echo "docs/reference.md: table of effects written"
