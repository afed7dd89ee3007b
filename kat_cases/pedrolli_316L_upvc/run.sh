#!/usr/bin/env bash
# Critical diameters with LIGGGHTS, beside theory, reduced model and measurement.
# run.sh [--short] [--out DIR] [options of powderlink kat run]
set -euo pipefail
cd "$(dirname "$0")"
. ../../scripts/kat_case.sh
kat_case pedrolli_316L_upvc "$@"
