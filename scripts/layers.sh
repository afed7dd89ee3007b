#!/usr/bin/env bash
# scripts/layers.sh [--write | --root DIR]: holds every #include of the repository against the table
# scripts/layers.txt, and the table against that of docs/architecture.md; --write writes the latter.
# --root: another tree with a table of its own, for the test of this script; its page is left alone.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
mode=check
case ${1:-} in
  --write) mode=write ;;
  --root) mode=tree root=$2 ;;
esac
cd "$root"
table=scripts/layers.txt
page=docs/architecture.md
status=0
broken() {  # what failed; given; allowed; to do
  printf 'layers: %s; given: %s; allowed: %s; to do: %s\n' "$@" >&2
  status=1
}

if [[ $mode == write || $mode == check ]]; then
  for marker in '<!-- layers:begin -->' '<!-- layers:end -->'; do
    [[ $(grep -cxF -- "$marker" "$page") -eq 1 ]] || {
      broken "a marker of the table" "$page" "one line '$marker'" "put the line back"
      exit 1
    }
  done
  written=$(mktemp)
  trap 'rm -f "$written"' EXIT
  awk -F ' *[|] *' -v table="$table" -v page="$page" '
    FILENAME == table {
      if (/^(#|never )/) next
      if (!rows) rows = "| folder | what it is | built as | includes |\n|---|---|---|---|\n"
      gsub(/[^ ]+/, "`&`", $2)
      sub(/^`-`$/, "nothing of ours", $2)
      rows = rows "| `" $1 "/` | " $3 " | " $4 " | " $2 " |\n"
      next
    }
    $0 == "<!-- layers:end -->" { inside = 0 }
    !inside { print }
    $0 == "<!-- layers:begin -->" { inside = 1; printf "%s", rows }' "$table" "$page" >"$written"
  if ! cmp -s "$written" "$page"; then
    if [[ $mode == check ]]; then
      broken "the table of $page is stale" "$page" "that of $table" "scripts/layers.sh --write"
    else
      cp "$written" "$page.part"
      mv "$page.part" "$page"
    fi
  fi
fi

files() {
  if [[ $mode == tree ]]; then find . -type f -printf '%P\n' | sort; else scripts/own_files.sh; fi
}
mapfile -t sources < <(files | grep -E '^(base|physics|liggghts_styles|coupling|kat_firmware|analysis)/.*\.(h|H|C|cpp|def|ino)$')

# A bare name is that of a file beside; one of OpenFOAM's style (.H) is found by its name alone.
while IFS= read -r line; do
  broken "${line%%;*}" "${line#*;}" "the folders in $table" \
    "turn the dependency round, move what both need into a lower folder, or change the table with a reason"
done < <(printf '%s\n' "${sources[@]}" | awk -F ' *[|] *' -v table="$table" '
  function folder(file) { sub(/\/[^\/]*$/, "", file); return file }
  function layer(file,  at) {
    for (at = folder(file); at != ""; ) {
      if (at in rank) return at
      if (at !~ /\//) return ""
      at = folder(at)
    }
  }
  BEGIN {
    while ((getline < table) > 0) {
      if (/^never /) {
        at = substr($0, 7)
        sub(/:.*/, "", at)
        sub(/^[^:]*: */, "")
        n = split($0, names, " ")
        for (i = 1; i <= n; i++) never[at, names[i]] = 1
        continue
      }
      if (/^#/ || NF < 2) continue
      rank[$1] = ++rows
      n = split($2, names, " ")
      for (i = 1; i <= n; i++) {
        if (names[i] == "-") continue
        may[$1, names[i]] = 1
        if (!(names[i] in rank) || names[i] == $1)
          printf "%s: row %s;%s is no row above it\n", table, $1, names[i]
      }
    }
    close(table)
  }
  {
    known[$0] = 1
    name = $0
    sub(/.*\//, "", name)
    if (name !~ /\.H$/) next
    if (name in by_name) by_name[name] = "two"
    else by_name[name] = $0
  }
  END {
    for (file in known) {
      from = layer(file)
      if (from == "") { printf "%s;its folder has no row\n", file; continue }
      line = 0
      while ((getline text < file) > 0) {
        line++
        if (text !~ /^[ \t]*#[ \t]*include[ \t]+["<]/) continue
        split(text, parts, /["<>]/)
        to = parts[2]
        for (at = folder(file); ; at = folder(at)) {
          if ((at, to) in never)
            printf "%s:%d: %s never includes it;#include %s\n", file, line, at, to
          if (at !~ /\//) break
        }
        if (!(to in known)) {
          beside = folder(file) "/" to
          if (beside in known) to = beside
          else if (to in by_name && by_name[to] != "two") to = by_name[to]
          else continue
        }
        into = layer(to)
        if (into != from && !((from, into) in may))
          printf "%s:%d: %s -> %s;#include \"%s\"\n", file, line, from, into, parts[2]
      }
      close(file)
    }
  }' | sort)
exit $status
