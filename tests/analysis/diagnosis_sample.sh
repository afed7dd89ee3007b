#!/usr/bin/env bash
# diagnosis_sample.sh MAKE_SETS DIAGNOSE_SETS: 30 sets with hidden effects, always the same; fails when a
# rate of right answers is below its target by more than chance allows (one in a thousand).
set -euo pipefail
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
"$1" "$work" 7 2 none=8 finite_stop_pulse rate_dependent_adhesion electrostatic_image_force \
  capillary_bridge surface_roughness plastic_contact psd_cutoff adhesion_scatter step=3 wave=3
"$2" "$work" 1 --check
