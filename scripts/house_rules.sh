#!/usr/bin/env bash
# Fails when a file of the repository breaks a rule that a machine can check; see CONTRIBUTING.md.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

max_bytes=$((1024 * 1024))
max_law_lines=150
laws=0
status=0
broken() {  # file[:line], rule
  printf 'house rules: %s: %s\n' "$1" "$2" >&2
  status=1
}

mapfile -t files < <(scripts/own_files.sh)

# The one place that says which headers hold a law and must name its source and its tests.
is_law_header() {  # file
  case $1 in
    tests/*) return 1 ;;
    # What all laws of a kind have in common, and their catalogue.
    */effect.h | */effect_registry.h | */force.h | */force_registry.h | */states.h | */vec3.h) return 1 ;;
    physics/*.h) return 0 ;;
  esac
  return 1
}

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
  if is_law_header "$file"; then
    laws=$((laws + 1))
    for line in Source Tests; do
      grep -qE "^///.*\b$line: [^ ]" -- "$file" ||
        broken "$file" "a law without a line '$line: ...'; say where it is from and what tests it"
    done
  fi
done

((laws > 0)) || broken scripts/house_rules.sh "is_law_header knows no file; have the laws moved?"

# What the comment `Tests: ...` of a header names, also on the lines below that go on with it.
while IFS=: read -r file line name; do
  if [[ -z $name ]]; then
    broken "$file:$line" "'Tests:' names no file; give paths from the root"
  elif [[ ! -e $name ]]; then
    broken "$file:$line" "'Tests:' names $name, which is not there; give its path from the root"
  fi
done < <(printf '%s\n' "${files[@]}" | grep -E '\.[hH]$' | tr '\n' '\0' | xargs -0 awk '
  function end_of_list() {
    if (start && !named) print file ":" start ":"
    start = 0
  }
  FNR == 1 || !/^(\/\/\/)? +[A-Za-z0-9_\/]+\.(cpp|sh)/ { end_of_list() }
  /^(\/\/\/|    ).*Tests: / { start = FNR; file = FILENAME; named = 0; sub(/.*Tests: /, "") }
  start {
    count = split($0, words, /[ ,;()]+/)
    for (i = 1; i <= count; ++i) {
      sub(/\.$/, "", words[i])
      if (words[i] ~ /[a-z]\/|\.(cpp|sh)$/) {
        print file ":" FNR ":" words[i]
        named = 1
      }
    }
  }
  END { end_of_list() }')
exit $status
