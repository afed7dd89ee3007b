#!/usr/bin/env bash
# observe_test.sh SOURCE WORK: what observe.sh of foam_cases/pipe measures, of a made-up run in which it is
# known. 100 states 0.5 ms apart, five blocks of 10 ms, numbered b = 1 to 5, after 0 s; 290 grains, one
# in each mm from 5 mm on:
#   grains   290 + b
#   velocity 10 m/s up to 0.15 m, then down to 3 + 0.1 b at 0.17 m, evenly; half way at 0.16 m
#   pressure falls by 20 000 + 100 b Pa/m, with a bend at 0.2 m
# Mean and half interval of a + c b: a + 3 c, and c t sqrt(2.5/5), t = 2.776445 of Student's distribution.
set -euo pipefail
case=$1/foam_cases/pipe out=$2/observe
fail() {
  echo "observe_test: $*" >&2
  exit 1
}
rm -rf "$out"
mkdir -p "$out"/{post,constant,postProcessing/axis/{0,0.02}}
cd "$out"
echo 'timestep 5e-7' >in.pipe
echo 'variable dt index "5e-7"' >in.inputs
echo 'rho [1 -3 0 0 0 0 0] 1.6355;' >constant/transportProperties
awk '
  function velocity(z, b) { return z < 0.15 ? 10 : z > 0.17 ? 3 + 0.1*b : 10 + (3 + 0.1*b - 10)*(z - 0.15)/0.02 }
  BEGIN {
    print "time_s,inserted,inside" >"post/particle_count.csv"
    for (i = 1; i <= 100; i++) {
      b = int((i - 1)/20) + 1
      file = sprintf("post/particles_%d.dump", 1000*i)
      printf "ITEM: TIMESTEP\n%d\nITEM: NUMBER OF ATOMS\n%d\nITEM: BOX BOUNDS ff ff ff\n-6.4e-4 6.4e-4\n-6.4e-4 6.4e-4\n-1e-5 0.3002\nITEM: ATOMS id type x y z vx vy vz radius mass\n", 1000*i, 290 >file
      for (k = 0; k < 290; k++)
        printf "%d 1 0 0 %.4f 0 0 %.9g 3e-5 1e-9\n", k + 1, 0.0055 + 0.001*k, velocity(0.0055 + 0.001*k, b) >file
      close(file)
      printf "%.4f,0,%d\n", 5e-4*i, 290 + b >"post/particle_count.csv"
    }
    # Two parts of a continued run, the first with a line that was cut off.
    for (part = 0; part < 2; part++) {
      file = "postProcessing/axis/" (part ? "0.02" : "0") "/p"
      for (k = 0; k < 30; k++) printf "# Probe %d (0 0 %.4g)\n", k, 0.005 + 0.01*k >file
      print "# Time" >file
      for (i = part ? 41 : 1; i <= (part ? 100 : 40); i++) {
        slope = 20000 + 100*(int((i - 1)/20) + 1)
        printf "%.4f", 5e-4*i >file
        for (k = 0; k < 30; k++) {
          z = 0.005 + 0.01*k
          printf " %.10g", (slope*(0.3 - z) + (z < 0.2 ? 3e4*(0.2 - z) : 0))/1.6355 >file
        }
        printf "\n" >file
      }
      if (!part) printf "%.4f 5000 40", 5e-4*41 >file
    }
  }'
line=$("$case/observe.sh" "$out" 0.00025 0.2 0.002 "$POWDERLINK_BIN/powderlink") || fail "status $?"
echo "$line"
IFS=, read -r grains grains_half velocity velocity_half spread slope slope_half rms rms_half front <<<"$line"
near() {  # what, value, expected, absolute tolerance
  awk -v x="$2" -v y="$3" -v t="$4" 'BEGIN { exit !(x ~ /[0-9]/ && (x - y)^2 <= t^2) }' || fail "$1: $2, not $3 +- $4"
}
half=1.96325  # of c = 1
near grains "$grains" 290 1e-9
near "its interval" "$grains_half" $half 2e-3
near velocity "$velocity" 3.3 1e-6
near "its interval" "$velocity_half" "0.196325" 1e-3
# Between the blocks alone: c sqrt(2).
near spread "$spread" 0.141421 1e-4
near slope "$slope" 20300 0.1
near "its interval" "$slope_half" 196.325 0.5
# The flow is 1e-9 kg times the velocity over 1 mm. Windows of 2 ms take 1 ms off the first and the last
# block, which are 2 c from the mean, and make ramps of the four steps of c: each takes c^2/6 of the
# mean square over 2 ms. That leaves c^2 ((2 9 4 + 2 10)/48 - 4 2/(6 48)).
near rms "$rms" "$(awk 'BEGIN { print 100*0.1*sqrt((92 - 8/6)/48)/3.3 }')" 0.01
# 24 windows of 2 ms: chi-square of 23 degrees of freedom, 11.6886 and 38.0756 at 2.5 and 97.5 %.
near "its interval" "$rms_half" "$(awk -v r="$rms" 'BEGIN { print r*(sqrt(23/11.6886) - sqrt(23/38.0756))/2 }')" 0.01
# Ten slices of 1 mm at a time.
near front "$front" 0.16 0.0015
