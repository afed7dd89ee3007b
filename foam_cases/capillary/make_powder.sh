#!/usr/bin/env bash
# make_powder.sh D10 D90 DENSITY > in.powder: 316L of which D10 and D90 [um, by mass] are known.
# A Rosin-Rammler law, finer than d: Y(d) = 1 - exp(-(d/x0)^n), without its finest and coarsest 2 %, goes
# through both: what is left has Y(D10) = 0.02 + 0.1*0.96, Y(D90) = 0.02 + 0.9*0.96, and so
#   n = ln(ln(1 - Y(D90))/ln(1 - Y(D10)))/ln(D90/D10),   x0 = D10/(-ln(1 - Y(D10)))^(1/n).
# 20 classes of the same mass, each with the grain that halves it; LIGGGHTS draws them by number, 1/d^3.
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
awk -v d10="$1" -v d90="$2" -v density="$3" -v classes=20 -v cut=0.02 \
  "$(<"$here/../../scripts/powder_classes.awk")"'
  function left(share) { return cut + share*(1 - 2*cut) }
  BEGIN {
    n = log(log(1 - left(0.9))/log(1 - left(0.1)))/log(d90/d10)
    x0 = d10/(-log(1 - left(0.1)))^(1/n)
    for (i = 1; i <= classes; i++) {
      d[i] = x0*(-log(1 - left((i - 0.5)/classes)))^(1/n)
      sum += d[i]^-3
    }
    # All classes weigh the same, so the mean mass is that of the harmonic mean of the volumes.
    mean = density*atan2(0, -1)/6*classes/sum*1e-18
    for (i = 1; i <= classes; i++) square += (d[i]^3*sum/classes - 1)^2*d[i]^-3/sum
    printf "# Made by make_powder.sh: Rosin-Rammler by mass, x0 %.2f um, n %.4f: D10 %g um, D90 %g um.\n", x0, n, d10, d90
    for (i = 1; i <= classes; i++) number[i] = d[i]^-3/sum
    print_powder(classes, d, number, density, mean, sqrt(square))
  }'
