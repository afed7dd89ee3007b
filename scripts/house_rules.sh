#!/usr/bin/env bash
# Fails when a file of the repository breaks a rule that a machine can check; see CONTRIBUTING.md.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

max_bytes=$((1024 * 1024))
max_law_lines=150
status=0
broken() {  # file[:line], rule
  printf 'house rules: %s: %s\n' "$1" "$2" >&2
  status=1
}

mapfile -t files < <(scripts/own_files.sh)

# One letter in brackets keeps this script from finding itself.
forbid() {  # extended regular expression, rule
  local hit
  while IFS= read -r hit; do
    broken "$hit" "$2"
  done < <(grep -InE -o -e "$1" -- "${files[@]}" /dev/null || true)
}
forbid '\.\./share[d]' 'mentions a folder outside the repository; keep what is needed inside'
forbid '(^|[^[:alnum:]_./)}~-])/(wor[k]|hom[e])/' "absolute path of one machine; use a path relative to the repository"
forbid '\b(TOD[O]|FIXM[E])\b' 'open end; finish it or write it down in docs/'

for file in "${files[@]}"; do
  bytes=$(stat -c %s -- "$file")
  if ((bytes > max_bytes)); then
    broken "$file" "$bytes bytes, at most $max_bytes; make it smaller or generate it"
  fi
  if [[ $file == physics/*.h ]]; then
    lines=$(wc -l <"$file")
    if ((lines > max_law_lines)); then
      broken "$file" "$lines lines, a law has at most $max_law_lines; split it"
    fi
  fi
done
exit $status
