#!/usr/bin/env bash
# scripts/lint.sh [--format | --tidy | --fix] [FILE...]
# --format: clang-format on our C++ files; --tidy: clang-tidy on what build/ compiles;
# neither: both; --fix: format in place.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

mode=all
case ${1:-} in
  --format | --tidy | --fix) mode=${1#--}; shift ;;
  -*) sed -n '2,4s/^# //p' "${BASH_SOURCE[0]}" >&2; exit 2 ;;
esac

for tool in clang-format clang-tidy; do
  command -v "$tool" >/dev/null || {
    echo "lint: $tool is missing; given: PATH; allowed: version 14 or later; to do: run scripts/setup.sh" >&2
    exit 1
  }
done

# Files with OpenFOAM's suffixes (.C, .H) keep OpenFOAM's own layout.
if [[ $# -gt 0 ]]; then
  files=("$@")
else
  mapfile -t files < <(scripts/own_files.sh | grep -E '\.(cpp|h|hpp)$' || true)
fi
[[ ${#files[@]} -gt 0 ]] || exit 0

status=0
if [[ $mode == fix ]]; then
  clang-format -i "${files[@]}"
fi
if [[ $mode == format || $mode == all ]]; then
  # One start for all files: it takes longer than a file.
  if ! complaints=$(clang-format --dry-run -Werror "${files[@]}" 2>&1); then
    status=1
    sed -n -E 's/^([^:]+):[0-9]+:.*clang-formatted.*/\1/p' <<<"$complaints" | sort -u |
      while IFS= read -r file; do
        echo "lint: $file: layout differs from .clang-format; to do: scripts/lint.sh --fix" >&2
      done
    grep -q 'clang-formatted' <<<"$complaints" || echo "$complaints" >&2
  fi
fi
if [[ $mode == tidy || $mode == all ]]; then
  # A configuration of its own, as the build compiles several sources at once; with the header it makes.
  flags=build/tidy
  mkdir -p build
  if ! { cmake --preset release -B "$flags" -DPOWDERLINK_UNITY=OFF &&
    cmake --build "$flags" --target build_commit; } >"$flags.log" 2>&1; then
    tail -n 20 "$flags.log" >&2
    echo "lint: cmake refused; given: $flags.log; allowed: a set-up machine; to do: scripts/setup.sh" >&2
    exit 1
  fi
  # Only files that the build compiles have flags to check them with.
  compiled=()
  for file in "${files[@]}"; do
    if grep -qF "\"file\": \"$PWD/$file\"" "$flags/compile_commands.json"; then compiled+=("$file"); fi
  done
  if [[ ${#compiled[@]} -gt 0 ]]; then
    printf '%s\0' "${compiled[@]}" |
      xargs -0 -n 1 -P "$(nproc)" timeout 600 clang-tidy --quiet -p "$flags" \
        2> >(grep -vE '^[0-9]+ warnings? generated' >&2) || status=1
  fi
fi
exit $status
