# awk -v density=RHO -v from=Z -f slope.awk postProcessing/axis/TIME/p: time and pressure drop per metre
# [Pa/m] over the probes beyond Z, least squares; no line where fewer than two probes are.
FNR == 1 { n = 0 }
/^# Probe/ { gsub(/[()]/, ""); z[n++] = $NF }
# The end of the part of a run that was stopped may be cut off.
!/^#/ && NF == n + 1 {
  m = mz = mp = zz = zp = 0
  for (i = 0; i < n; i++) if (z[i] > from) { m++; mz += z[i]; mp += density*$(i + 2) }
  if (m < 2) next
  for (i = 0; i < n; i++) if (z[i] > from) { zz += (z[i] - mz/m)^2; zp += (z[i] - mz/m)*(density*$(i + 2) - mp/m) }
  printf "%.9g %.9g\n", $1, -zp/zz
}
