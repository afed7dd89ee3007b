#!/usr/bin/env bash
# diagnosis_sample.sh MAKE_SETS DIAGNOSE_SETS: 30 sets with hidden effects, always the same, so that their
# answers do not depend on chance; fails when a rate misses its target: of 16 effects 15 first or not told
# apart, 12 named alone, one other named at most; one false alarm of 8 at most; of 6 from outside the
# catalogue 5 not explained and none named alone.
set -euo pipefail
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
"$1" "$work" 7 2 none=8 finite_stop_pulse rate_dependent_adhesion electrostatic_image_force \
  capillary_bridge surface_roughness plastic_contact psd_cutoff adhesion_scatter step=3 wave=3
"$2" "$work" 1 --check
