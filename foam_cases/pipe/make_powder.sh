#!/usr/bin/env bash
# make_powder.sh LAW ORIGIN EXPONENT SCALE|mean:MASS DENSITY > in.powder: the classes of the powder.
# A Rosin-Rammler law that begins at ORIGIN [m], finer than d: Y(d) = 1 - exp(-((d - ORIGIN)/SCALE)^n),
# cut off at 40 and 110 um. LAW number: Y counts grains, and a class gets Y(d2) - Y(d1) of them. LAW
# mass: Y weighs them, and it gets (Y(d2) - Y(d1))/d^3, d its middle. LIGGGHTS draws by these numbers.
# mean:MASS takes the SCALE with which the mean mass of a grain is MASS [kg].
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
awk -v law="$1" -v origin="$2" -v n="$3" -v scale="$4" -v density="$5" \
  -v d_min=40 -v d_max=110 -v width=5 "$(<"$here/../../scripts/powder_classes.awk")"'
  # Y between the cuts, as a share; without the factor by which Y(d_min) may be all but 1.
  function beyond(d) { return 1 - exp(((d_min - origin)/x0)^n - ((d - origin)/x0)^n) }
  function finer(d) { return beyond(d)/beyond(d_max) }
  function mass(d) { return density*pi/6*(d*1e-6)^3 }
  function classes_of(scale_um,  low, k) {
    x0 = scale_um; classes = sum = mean = square = median = 0
    for (low = d_min; low < d_max; low += width) {
      d[++classes] = low + width/2
      number[classes] = (finer(low + width) - finer(low))/(law == "mass" ? d[classes]^3 : 1)
      sum += number[classes]
    }
    for (k = 1; k <= classes; k++) {
      mean += number[k]/sum*mass(d[k])
      square += number[k]/sum*mass(d[k])^2
    }
  }
  BEGIN {
    pi = atan2(0, -1)
    origin *= 1e6
    if (sub(/^mean:/, "", scale)) {
      scale += 0
      # The mean grows with the scale: halve the interval.
      low = 1; high = 1000
      while (high - low > 1e-9*high) {
        classes_of((low + high)/2)
        if (mean < scale) low = x0; else high = x0
      }
      if (mean < 0.999*scale || mean > 1.001*scale) {
        classes_of(1); least = mean
        classes_of(1000); most = mean
        printf "%.4g to %.4g", least, most >"/dev/stderr"
        exit 1
      }
    } else classes_of(scale*1e6)
    for (k = 1; k <= classes; k++) {
      before = by_mass
      by_mass += number[k]/sum*mass(d[k])/mean
      if (by_mass >= 0.5) { median = d[k] + width*((0.5 - before)/(by_mass - before) - 0.5); break }
    }
    printf "# Made by make_powder.sh: 316L, Rosin-Rammler by %s from %g um on, x0 %.4g um, n %g, %g to %g um.\n", law, origin, x0, n, d_min, d_max
    printf "# Mass median %.1f um.\n", median
    for (k = 1; k <= classes; k++) number[k] /= sum
    print_powder(classes, d, number, density, mean, sqrt(square - mean^2)/mean)
  }'
