# awk -v rho=DENSITY -f momentum.awk volFieldValue.dat momentum.txt
# Fluid plus particles: what their momentum gains from the first common time on, less the impulse of
# gravity, over the largest momentum exchanged (along x) or the impulse. Lines: name value.
function abs(x) { return x < 0 ? -x : x }
BEGIN {
  weight = 1000*7950*3.14159265358979/6*75e-6^3*9.81
  split("x y z", axis, " ")
}
/^#/ { next }
{ time = sprintf("%.7f", $1); gsub(/[()]/, " ") }
FNR == NR { for (i = 1; i <= 3; i++) fluid[time, i] = rho*$(1 + i); next }
(time, 1) in fluid {
  if (!started) { started = 1; start = time; for (i = 1; i <= 3; i++) { g0[i] = fluid[time, i]; p0[i] = $(1 + i) } }
  for (i = 1; i <= 3; i++) {
    off = abs(fluid[time, i] + $(1 + i) - g0[i] - p0[i] + (i == 3 ? weight*(time - start) : 0))
    if (off > worst[i]) worst[i] = off
  }
  exchanged = abs(fluid[time, 1] - g0[1])
  if (exchanged > scale) scale = exchanged
  rows++
}
END {
  if (rows < 10) exit 1
  for (i = 1; i <= 3; i++) printf "momentum_%s %.3e\n", axis[i], worst[i]/scale
}
