#!/usr/bin/env bash
# coverage.sh [COMPILER]: lines and branches of kat_firmware/core that its tests take; fails below 100 %.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
compiler=${1:-g++}
if ! command -v gcovr >/dev/null; then
  echo "coverage: gcovr is missing; given: PATH; allowed: gcovr 5 or later; to do: run scripts/setup.sh" >&2
  exit 1
fi
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"

# The core as the device has it, without exceptions: with them gcov counts branches that only they take.
for source in "$root"/kat_firmware/core/*.cpp; do
  "$compiler" -std=c++11 -O0 --coverage -fno-exceptions -fno-rtti -I"$root" -c "$source" -o "core_$(basename "$source" .cpp).o"
done
for source in "$root"/tests/kat_firmware/*_test.cpp; do
  "$compiler" -std=c++17 -O0 -I"$root" -c "$source" -o "$(basename "$source" .cpp).o"
done
# Of functions in headers the linker keeps the first copy: that of the core.
"$compiler" --coverage core_*.o ./*_test.o -lgtest -lgtest_main -pthread -o firmware_test
timeout 300 ./firmware_test --gtest_brief=1
gcovr --root "$root" --filter "$root/kat_firmware/core/" --object-directory "$folder" --branches "$folder" \
  --print-summary --fail-under-branch 100 --fail-under-line 100
