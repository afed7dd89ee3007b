#!/usr/bin/env bash
# Critical diameters with LIGGGHTS, beside theory, reduced model and measurement.
set -euo pipefail
cd "$(dirname "$0")"
mkdir -p results
../../powderlink kat run study.toml --out results --json results/kat.json "$@"
