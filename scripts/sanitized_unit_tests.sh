#!/usr/bin/env bash
# The tests labelled `unit`, with address and undefined-behaviour sanitizers.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
scripts/build.sh sanitize unit_tests
exec ctest --preset sanitize --no-tests=error
