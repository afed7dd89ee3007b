#!/usr/bin/env bash
# make_powder.sh > in.powder: the classes of the powder, from its Rosin-Rammler parameters.
# By mass, finer than d: Y(d) = 1 - exp(-(d/x0)^n), cut off at d_min and d_max. A class gets
# (Y(d2) - Y(d1))/d^3 grains, d its middle: the number fractions that LIGGGHTS draws from.
set -euo pipefail
awk -v x0=70.7 -v n=4 -v d_min=40 -v d_max=110 -v width=5 -v density=7950 '
  function finer(d) { return (exp(-(d_min/x0)^n) - exp(-(d/x0)^n))/(exp(-(d_min/x0)^n) - exp(-(d_max/x0)^n)) }
  BEGIN {
    # Seeds of LIGGGHTS: primes, all different.
    split("10007 10009 10037 10039 10061 10067 10069 10079 10091 10093 10099 10103 10111 10133", seed)
    pi = atan2(0, -1)
    for (low = d_min; low < d_max; low += width) {
      d[++classes] = low + width/2
      number[classes] = (finer(low + width) - finer(low))/d[classes]^3
      sum += number[classes]
    }
    for (i = 1; i <= classes; i++) mean += number[i]/sum*density*pi/6*(d[i]*1e-6)^3
    for (median = d_min; finer(median) < 0.5; ) median += 0.01
    printf "# Made by make_powder.sh: 316L, Rosin-Rammler by mass, x0 %g um, n %g, %g to %g um.\n", x0, n, d_min, d_max
    printf "# Mass median %.1f um, mean mass of a grain %.3e kg.\n", median, mean
    for (i = 1; i <= classes; i++)
      printf "fix class%-2d all particletemplate/sphere %d atom_type 1 density constant %g radius constant %.6ge-6 volume_limit 1e-20\n", \
        i, seed[i], density, d[i]/2
    printf "fix powder all particledistribution/discrete/numberbased 15485867 %d", classes
    for (i = 1; i <= classes; i++) printf " &\n    class%-2d %.6f", i, number[i]/sum
    printf "\n"
  }'
