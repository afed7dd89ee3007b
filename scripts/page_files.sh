#!/usr/bin/env bash
# scripts/page_files.sh PAGE FOLDER
# Writes the files that a page shows into FOLDER, in the page's order; where a name comes twice, the
# last one stays. A block is one when a line before it says so:
#   <!-- file: NAME -->, <!-- run: NAME expect: TEXT -->     NAME may lie in folders: system/controlDict
# Nothing that is in FOLDER is overwritten.
set -euo pipefail

fail() {  # what failed; given; allowed; to do
  printf 'page_files.sh: %s; given: %s; allowed: %s; to do: %s\n' "$@" >&2
  exit 1
}

[[ $# -eq 2 ]] || fail "wrong arguments" "$*" "PAGE FOLDER" "scripts/page_files.sh docs/first_coupled_job.md duct"
[[ -f $1 ]] || fail "no such page" "$1" "a page with files" "correct the path"
[[ ! -e $2 || -d $2 && -z $(ls -A "$2") ]] || fail "the folder is in use" "$2" "a new or empty folder" "name another one"

mkdir -p "$2"
awk -v folder="$2" '
  /^<!-- (run|file): / { name = $3; next }
  name != "" && /^```/ {
    if (!inside) {
      inside = 1; path = folder "/" name
      parent = path; sub("/[^/]*$", "", parent)
      quoted = parent; gsub("\047", "\047\\\047\047", quoted)
      system("mkdir -p \047" quoted "\047")
      printf "" > path
      next
    }
    close(path); inside = 0; name = ""; next
  }
  inside { print >> path }' "$1"
