#!/usr/bin/env bash
# scripts/check_docs.sh [--links | --forces | --scripts LAUNCHER]
# --links: every relative link of our pages leads to a file, and so does every path of the sources that they name.
# --forces: every law of forces.def has its row in docs/theory_coupling.md, and every row its law.
# --scripts: every LIGGGHTS script and every job shown in a page, in one folder per page and in its order,
#   ends with status 0 and prints what the page says. Marked by a line before its block:
#   <!-- file: NAME -->                     written only (scripts/page_files.sh)
#   <!-- run: NAME expect: TEXT -->         written and run; TEXT must be in the output
#   <!-- shell: NAME expect: TEXT -->       commands, run by bash with the launcher's folder in PATH
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
root=$PWD
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
    # A path in backticks, but for patterns with NAME.
    while IFS= read -r target; do
      [[ $target == *NAME* || -e $target ]] ||
        broken "$page: path $target; given: no such file; allowed: a path from the root; to do: correct it"
    done < <(grep -oE '`(base|physics|liggghts_styles|coupling|analysis|kat_firmware|scripts|tests|findings|cmake)/[A-Za-z0-9_./-]+`' "$page" | tr -d '`')
  done
}

forces() {
  local list=physics/fluid_forces/forces.def page=docs/theory_coupling.md header name laws=() rows=()
  while IFS= read -r header; do
    name=$(sed -nE 's/^POWDERLINK_FORCE\(([a-z0-9_]+),.*/\1/p' "$header" 2>/dev/null || true)
    if [[ -n $name ]]; then
      laws+=("$name")
    else
      broken "$header of $list; given: no line POWDERLINK_FORCE(name, Class); allowed: one; to do: see the other laws"
    fi
  done < <(sed -nE 's/^#include "(.*)"$/\1/p' "$list")
  # shellcheck disable=SC2016
  mapfile -t rows < <(sed -n '/^<!-- forces:begin -->$/,/^<!-- forces:end -->$/s/^| `\([^`]*\)` |.*/\1/p' "$page")
  ((${#laws[@]} > 0)) || broken "$list: given: no laws; allowed: one line #include per law; to do: see its head"
  for name in "${laws[@]}"; do
    (($(printf '%s\n' "${rows[@]}" | grep -cxF -- "$name" || true) == 1)) ||
      broken "$page: table of forces; given: not one row for $name of $list; allowed: one; to do: write its law there"
  done
  for name in "${rows[@]}"; do
    printf '%s\n' "${laws[@]}" | grep -qxF -- "$name" ||
      broken "$page: table of forces; given: $name; allowed: laws of $list; to do: remove the row or correct its name"
  done
}

scripts() {
  local launcher=$1 page folder kind name text run
  [[ -x $launcher ]] || { broken "launcher; given: $launcher; allowed: a program; to do: build it"; return; }
  # As the pages' readers have them.
  launcher=$(realpath "$launcher")
  export PATH=${launcher%/*}:$PATH WM_PROJECT_DIR=${WM_PROJECT_DIR:-/usr/share/openfoam}
  export OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1
  export OMPI_MCA_rmaps_base_oversubscribe=1 OMPI_MCA_hwloc_base_binding_policy=none OMPI_MCA_mpi_yield_when_idle=1
  work=$(mktemp -d)
  trap 'rm -rf "$work"' EXIT
  for page in "${pages[@]}"; do
    folder=$work/${page//\//_}
    "$root/scripts/page_files.sh" "$page" "$folder"
    awk -v folder="$folder" '
      /^<!-- (run|shell): / { kind = $2; name = $3; text = ""
        if (match($0, / expect: .* -->$/)) text = substr($0, RSTART + 9, RLENGTH - 13)
        next }
      name != "" && /^```/ {
        if (!inside) { inside = 1; next }
        if (kind == "shell:") close(folder "/" name)
        printf "%s\t%s\t%s\n", kind, name, text > (folder "/runs.txt")
        inside = 0; name = ""; next }
      inside && kind == "shell:" { print > (folder "/" name) }' "$page"
    [[ -f $folder/runs.txt ]] || continue
    while IFS=$'\t' read -r kind name text; do
      run=("$launcher" -in "$name")
      if [[ $kind == shell: ]]; then
        [[ -x ${launcher%/*}/powderFoam ]] || { echo "check_docs: $page, $name: left out, built without OpenFOAM"; continue; }
        run=(bash -euo pipefail "$name")
      fi
      if ! (cd "$folder" && timeout "$run_limit_s" "${run[@]}" >"$name.out" 2>&1 </dev/null); then
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
  --forces) forces ;;
  --scripts) scripts "${2:?launcher: build/bin/liggghts-powderlink}" ;;
  *) sed -n '2,10s/^# //p' "${BASH_SOURCE[0]}" >&2; exit 2 ;;
esac
exit $status
