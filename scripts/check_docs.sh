#!/usr/bin/env bash
# scripts/check_docs.sh [--links | --scripts LAUNCHER]
# --links: every relative link of our pages leads to a file.
# --scripts: every LIGGGHTS script shown in a page, in one folder per page and in its order, ends with
#   status 0 and prints what the page says. Marked by a line before its block:
#   <!-- file: NAME -->                     written only
#   <!-- run: NAME expect: TEXT -->         written and run; TEXT must be in the output
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
shopt -s nullglob
run_limit_s=120
pages=(README.md CONTRIBUTING.md CHANGELOG.md docs/*.md)
status=0
broken() {
  printf 'check_docs: %s\n' "$1" >&2
  status=1
}

links() {
  local page target
  for page in "${pages[@]}"; do
    while IFS= read -r target; do
      target=${target%%#*}
      [[ -z $target || $target == *://* || $target == mailto:* || -e $(dirname "$page")/$target ]] ||
        broken "$page: link to $target; given: no such file; allowed: a file of the repository; to do: correct the link"
    done < <(grep -oE '\]\([^)]+\)' "$page" | sed -E 's/^\]\(//; s/\)$//')
  done
}

scripts() {
  local launcher=$1 page folder name text
  [[ -x $launcher ]] || { broken "launcher; given: $launcher; allowed: a program; to do: build it"; return; }
  work=$(mktemp -d)
  trap 'rm -rf "$work"' EXIT
  for page in "${pages[@]}"; do
    folder=$work/${page//\//_}
    mkdir -p "$folder"
    awk -v folder="$folder" '
      /^<!-- (run|file): / { kind = $2; name = $3; text = ""
        if (match($0, / expect: .* -->$/)) text = substr($0, RSTART + 9, RLENGTH - 13)
        next }
      name != "" && /^```/ {
        if (!inside) { inside = 1; next }
        close(folder "/" name)
        if (kind == "run:") printf "%s\t%s\n", name, text > (folder "/runs.txt")
        inside = 0; name = ""; next }
      inside { print > (folder "/" name) }' "$page"
    [[ -f $folder/runs.txt ]] || continue
    while IFS=$'\t' read -r name text; do
      if ! (cd "$folder" && timeout "$run_limit_s" "$launcher" -in "$name" >"$name.out" 2>&1 </dev/null); then
        tail -n 5 "$folder/$name.out" >&2
        broken "$page, script $name: did not end with status 0"
      elif ! grep -qF -- "$text" "$folder/$name.out"; then
        tail -n 5 "$folder/$name.out" >&2
        broken "$page, script $name: '$text' is not in its output"
      fi
    done <"$folder/runs.txt"
  done
}

case ${1:-} in
  --links) links ;;
  --scripts) scripts "${2:?launcher: build/bin/liggghts-powderlink}" ;;
  *) sed -n '2,7s/^# //p' "${BASH_SOURCE[0]}" >&2; exit 2 ;;
esac
exit $status
