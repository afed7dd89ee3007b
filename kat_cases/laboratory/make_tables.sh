#!/usr/bin/env bash
# make_tables.sh: writes drops/*.csv and contact_radii.csv, the example of docs/laboratory.md, from a
# known truth. Deterministic (the generator of Park and Miller), so that a second call changes nothing.
#
#   powder      316L, ln d normal: median 42 um, standard deviation 0.4
#   plate       UPVC; Gamma lognormal, median 0.0825 J/m^2, standard deviation of ln Gamma 0.16
#   stop        half-sine of 100 us; slow for the contact, so that d_c = 46 um sqrt(1.4 m/s / v), the
#               d_c of every grain with half the scatter of Gamma
#   pictures    450 grains before, 0.5 um per pixel; after the drop another place of the same size
#   contact radii: the dark ring sqrt(R lambda) of grains that do not adhere, read to 4 %
set -euo pipefail
cd "$(dirname "$0")"
mkdir -p drops
awk '
function uniform() { seed = (16807 * seed) % 2147483647; return seed / 2147483647 }
function normal(  a) { a = sqrt(-2 * log(uniform())); return a * cos(2 * pi * uniform()) }
function size() { return 42 * exp(0.4 * normal()) }
function grain(file, n, d,  pixels) {
  pixels = d / 0.5
  printf "%d,%d,%.2f,%.3f\n", n, 0.25 * pi * pixels * pixels + 0.5, pi * pixels * 1.02, 1 / 1.02 ^ 2 > file
}
BEGIN {
  pi = 3.14159265358979
  seed = 20260
  drops = split("0.7 1.0 1.4 2.0 2.8 4.0", velocity, " ")
  for (k = 1; k <= drops; k++) {
    critical = 46 * sqrt(1.4 / velocity[k])
    before = "drops/before_" velocity[k] ".csv"
    after = "drops/after_" velocity[k] ".csv"
    print " ,Area,Perim.,Circ." > before
    print " ,Area,Perim.,Circ." > after
    stayed = 0
    for (i = 1; i <= 450; i++) grain(before, i, size())
    for (i = 1; i <= 450; i++) {
      d = size()
      if (d < critical * exp(0.08 * normal())) grain(after, ++stayed, d)
    }
  }
  print "# contact radii under the microscope, 550 nm" > "contact_radii.csv"
  print "contact_radius_um,radius_um,wavelength_nm" > "contact_radii.csv"
  for (i = 1; i <= 8; i++) {
    radius = 0.5 * size()
    printf "%.2f,%.1f,550\n", sqrt(radius * 0.55) * exp(0.04 * normal()), radius > "contact_radii.csv"
  }
}'
