#!/usr/bin/env bash
# bench/diagnosis/run.sh [SETS-PER-KIND [SEED [FOLDER]]]: the study of docs/diagnosis.md. Makes sets with
# a hidden effect (default 40 of each of the 8 effects, 50 of each of the 2 kinds outside the catalogue,
# 300 with nothing) and prints the confusion matrix; status 1 when a rate misses its target. Takes about
# a second of processor time per set.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
sets=${1:-40}
seed=${2:-2027}
folder=${3:-$root/results/diagnosis}
"$root/scripts/build.sh" release make_diagnosis_sets
"$root/scripts/build.sh" release diagnose_sets
bin=$root/build/test_bin
rm -rf "$folder"
"$bin/make_diagnosis_sets" "$folder" "$seed" "$sets" none=$((sets * 15 / 2)) finite_stop_pulse \
  rate_dependent_adhesion electrostatic_image_force capillary_bridge surface_roughness plastic_contact \
  psd_cutoff adhesion_scatter step=$((sets * 5 / 4)) wave=$((sets * 5 / 4))
"$bin/diagnose_sets" "$folder" "$(nproc)" --check
