#!/usr/bin/env bash
# make_powder.sh LAW ORIGIN EXPONENT SCALE|mean:MASS DENSITY > in.powder: the classes of the powder.
# A Rosin-Rammler law that begins at ORIGIN [m], finer than d: Y(d) = 1 - exp(-((d - ORIGIN)/SCALE)^n),
# cut off at 40 and 110 um. LAW number: Y counts grains, and a class gets Y(d2) - Y(d1) of them. LAW
# mass: Y weighs them, and it gets (Y(d2) - Y(d1))/d^3, d its middle. LIGGGHTS draws by these numbers.
# mean:MASS takes the SCALE with which the mean mass of a grain is MASS [kg].
set -euo pipefail
awk -v law="$1" -v origin="$2" -v n="$3" -v scale="$4" -v density="$5" \
  -v d_min=40 -v d_max=110 -v width=5 '
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
    # Seeds of LIGGGHTS: primes, all different.
    split("10007 10009 10037 10039 10061 10067 10069 10079 10091 10093 10099 10103 10111 10133", seed)
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
    printf "variable grainMass     index %.4g    # kg, mean of a grain\n", mean
    printf "variable grainSpread   index %.3f    # standard deviation of that mass over its mean\n", sqrt(square - mean^2)/mean
    printf "variable smallestGrain index %.6ge-6    # m, radius\n", d[1]/2
    printf "variable largestGrain  index %.6ge-6    # m, radius\n", d[classes]/2
    for (k = 1; k <= classes; k++)
      printf "fix class%-2d all particletemplate/sphere %d atom_type 1 density constant %g radius constant %.6ge-6 volume_limit 1e-20\n", \
        k, seed[k], density, d[k]/2
    printf "fix powder all particledistribution/discrete/numberbased 15485867 %d", classes
    for (k = 1; k <= classes; k++) printf " &\n    class%-2d %.6f", k, number[k]/sum
    printf "\n"
  }'
