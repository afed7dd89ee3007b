# print_powder(classes, d, share, density, mean, spread): the powder of a case as LIGGGHTS reads it, of classes
# of diameter d[1..classes] [um], in ascending order, with share[k] of the grains each; beside it the
# variables that the case uses: mean mass [kg], its relative spread, smallest and largest radius.
# Awk functions of foam_cases/*/make_powder.sh.
function print_powder(classes, d, share, density, mean, spread,  k, seed) {
  # Seeds of LIGGGHTS: primes, all different.
  split("10007 10009 10037 10039 10061 10067 10069 10079 10091 10093 10099 10103 10111 10133 10139 10141 " \
    "10151 10159 10163 10169", seed)
  printf "variable grainMass     index %.5g    # kg, mean of a grain\n", mean
  printf "variable grainSpread   index %.3f    # standard deviation of that mass over its mean\n", spread
  printf "variable smallestGrain index %.6ge-6    # m, radius\n", d[1]/2
  printf "variable largestGrain  index %.6ge-6    # m, radius\n", d[classes]/2
  for (k = 1; k <= classes; k++)
    printf "fix class%-2d all particletemplate/sphere %d atom_type 1 density constant %g radius constant %.6ge-6 volume_limit 1e-20\n", \
      k, seed[k], density, d[k]/2
  printf "fix powder all particledistribution/discrete/numberbased 15485867 %d", classes
  for (k = 1; k <= classes; k++) printf " &\n    class%-2d %.6f", k, share[k]
  printf "\n"
}
