#!/usr/bin/env bash
# Configures if needed and builds what changed: scripts/build.sh PRESET TARGET
# Quiet unless it fails; one build at a time in this folder.
set -euo pipefail

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
preset=$1
target=$2
lock_limit_s=3600
build_limit_s=7200
case $preset in
  release) build=$root/build ;;
  *) build=$root/build/$preset ;;
esac
log=$build/build.log
cd "$root"
mkdir -p "$build"

fail() {  # what failed; what was given; what is allowed; what to do
  printf 'build: %s\n  given:   %s\n  allowed: %s\n  to do:   %s\n' "$@" >&2
  exit 1
}

exec 9>"$build/.lock"
if ! flock --nonblock 9; then
  echo "powderlink: waiting for another build of this folder" >&2
  flock --timeout "$lock_limit_s" 9 ||
    fail "another build did not end within $lock_limit_s s" "build folder ${build#"$root"/}" \
      "one build at a time" "end the other build, then try again"
fi

run() {  # everything to the log; its end to the user when it fails
  local status=0
  timeout --foreground --kill-after=10 "$build_limit_s" "$@" >"$log" 2>&1 9>&- || status=$?
  if [[ $status -ne 0 ]]; then
    tail -n 60 "$log" >&2
    fail "'$*' ended with status $status" "preset $preset" "a build without errors" \
      "read the messages above; the whole log is ${log#"$root"/}"
  fi
}

# A build folder copied to another place, processor (-march=native) or OpenFOAM starts anew;
# OpenFOAM headers that have come only need another look.
own_foam=
if [[ -d ${WM_PROJECT_DIR:-}/src/OpenFOAM/lnInclude ]]; then own_foam=$WM_PROJECT_DIR; fi
machine=$({ echo "$root" "$own_foam"; grep -m1 '^flags' /proc/cpuinfo || true; } | cksum)
headers=$(cat "$root/build/openfoam/.stamp" 2>/dev/null || true)
known=()
if [[ -f $build/.configured ]]; then mapfile -t known <"$build/.configured"; fi

if [[ ! -f $build/build.ninja || ${known[0]:-} != "$machine" || ${known[1]:-} != "$headers" ]]; then
  echo "powderlink: configuring ($preset)" >&2
  cache_root=$(sed -n 's/^CMAKE_HOME_DIRECTORY:INTERNAL=//p' "$build/CMakeCache.txt" 2>/dev/null || true)
  if [[ $cache_root == "$root" && ${known[0]:-$machine} == "$machine" ]]; then
    run cmake --preset "$preset"
  else
    run cmake --fresh --preset "$preset"
    run cmake --build --preset "$preset" --target clean
  fi
  printf '%s\n' "$machine" "$headers" >"$build/.configured"
fi

steps=$(ninja -C "$build" -n "$target" 2>/dev/null | grep -c '^\[' || true)
if [[ $steps -gt 0 ]]; then
  echo "powderlink: building ($preset, $steps steps)" >&2
  run cmake --build --preset "$preset" --target "$target"
fi
