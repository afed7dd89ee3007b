#!/usr/bin/env bash
# The tests labelled `unit` or `sanitized`, with address and undefined-behaviour sanitizers.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
scripts/build.sh sanitize tests_to_sanitize
exec ctest --preset sanitize --no-tests=error
