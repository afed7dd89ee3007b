#!/usr/bin/env bash
# make_powder.sh D10 D90 DENSITY > in.powder: 316L of which D10 and D90 [um, by mass] are known.
# A Rosin-Rammler law, finer than d: Y(d) = 1 - exp(-(d/x0)^n), without its finest and coarsest 2 %, goes
# through both: what is left has Y(D10) = 0.02 + 0.1*0.96, Y(D90) = 0.02 + 0.9*0.96, and so
#   n = ln(ln(1 - Y(D90))/ln(1 - Y(D10)))/ln(D90/D10),   x0 = D10/(-ln(1 - Y(D10)))^(1/n).
# 20 classes of the same mass, each with the grain that halves it; LIGGGHTS draws them by number, 1/d^3.
set -euo pipefail
awk -v d10="$1" -v d90="$2" -v density="$3" -v classes=20 -v cut=0.02 '
  function left(share) { return cut + share*(1 - 2*cut) }
  BEGIN {
    # Seeds of LIGGGHTS: primes, all different.
    split("10007 10009 10037 10039 10061 10067 10069 10079 10091 10093 10099 10103 10111 10133 10139 10141 " \
      "10151 10159 10163 10169", seed)
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
    printf "variable grainMass     equal %.5g    # kg, mean of a grain\n", mean
    printf "variable grainSpread   equal %.3f    # standard deviation of that mass over its mean\n", sqrt(square)
    printf "variable smallestGrain equal %.5ge-6    # m, radius\n", d[1]/2
    printf "variable largestGrain  equal %.5ge-6    # m, radius\n", d[classes]/2
    for (i = 1; i <= classes; i++)
      printf "fix class%-2d all particletemplate/sphere %d atom_type 1 density constant %g radius constant %.5ge-6 volume_limit 1e-20\n", \
        i, seed[i], density, d[i]/2
    printf "fix powder all particledistribution/discrete/numberbased 15485867 %d", classes
    for (i = 1; i <= classes; i++) printf " &\n    class%-2d %.6f", i, d[i]^-3/sum
    printf "\n"
  }'
