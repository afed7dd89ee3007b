#!/usr/bin/env bash
# Removes everything that run.sh made.
set -euo pipefail
cd "$(dirname "$0")"
rm -rf results results.json
