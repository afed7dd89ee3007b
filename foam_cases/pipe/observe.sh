#!/usr/bin/env bash
# observe.sh CASE FROM PLACE WINDOW POWDERLINK: one line of a run's developed part, from the time FROM [s]
# on and beyond PLACE [m], rms of the solids flow after a moving average of WINDOW [s]:
#   grains,+-,velocity_m_s,+-,velocity_std_m_s,slope_Pa_m,+-,rms_percent,+-,front_m
# +-: half of a 95 % interval of the mean, from the means of five blocks of time; blocks shorter than the
# time that grains stay hang together: then the interval is too narrow rather than too wide. Of the rms
# half of the interval of powderlink flow. front: that of powderlink flow; "-" for none.
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
case=$1 from=$2 place=$3 window=$4 powderlink=$5
out=$case/flow
density=1.6355  # kg/m3, as in constant/transportProperties
mkdir -p "$out"
"$powderlink" flow "$case" --from "$from" --from-z "$place" --average "$window" --no-figures \
  --out "$out" --json "$out/flow.json" >"$out/log" 2>&1 || { cat "$out/log" >&2; exit 1; }
number() { sed -n -E "s/^ *\"$1\": ([-+0-9.e]+),?\$/\1/p" "$out/flow.json"; }

# Lines of time and value, in the order of time. Student's t of four degrees of freedom: 2.776.
half_interval() {
  awk -v from="$from" '
    $1 > from - 1e-9 { t[++n] = $1; x[n] = $2 }
    END {
      blocks = 5
      if (n < blocks) { print "-"; exit }
      for (i = 1; i <= n; i++) { b = int((i - 1)*blocks/n); sum[b] += x[i]; count[b]++ }
      for (b = 0; b < blocks; b++) mean += sum[b]/count[b]/blocks
      for (b = 0; b < blocks; b++) square += (sum[b]/count[b] - mean)^2/(blocks - 1)
      printf "%.4g\n", 2.776*sqrt(square/blocks)
    }'
}

grains=$(awk -F, 'NR > 1 { print $1, $3 }' "$case/post/particle_count.csv" | half_interval)
dt=$(awk '$2 == "dt" { gsub(/"/, ""); print $4 }' "$case/in.inputs")
velocity=$(find "$case/post" -name 'particles_*.dump' | sort -V | xargs awk -v dt="$dt" -v place="$place" '
  function line() { if (n) printf "%.9g %.9g\n", step*dt, sum/n; n = sum = 0 }
  /^ITEM: TIMESTEP/ { line(); getline step; rows = 0; next }
  /^ITEM: ATOMS/ { for (i = 3; i <= NF; i++) { if ($i == "z") z = i - 2; if ($i == "vz") v = i - 2 } rows = 1; next }
  rows && $z >= place { n++; sum += $v }
  END { line() }' | half_interval)
slope=$(cd "$case" && find postProcessing/axis -name p | LC_ALL=C sort -t/ -k3,3g |
  xargs awk -v density="$density" -v from="$(awk "BEGIN { print 0.999*$place }")" -f "$here/slope.awk" |
  sort -g -u -k1,1 | half_interval)
rms=$(number solids_flow_rms_percent)
# One of value, low, high of a number, which may have no interval; nothing where it is not there.
within() {  # key, which
  awk -v key="\"$1\":" -v which="\"$2\":" '
    { gsub(/,/, "") }
    $1 == key && $2 != "{" { if (which ~ /value/ && $2 != "null") print $2; exit }
    $1 == key { among = 1 }
    among && $1 == which { print $2; exit }' "$out/flow.json"
}
rms_half=$(awk -v low="$(within solids_flow_rms_interval_percent low)" \
  -v high="$(within solids_flow_rms_interval_percent high)" \
  'BEGIN { if (high == "") print "-"; else printf "%.3g", (high - low)/2 }')
front=$(within front_m value)
printf '%s,%s,%s,%s,%s,%s,%s,%s,%s,%s\n' "$(number particle_count)" "$grains" \
  "$(number particle_velocity_mean_m_s)" "$velocity" "$(number particle_velocity_std_m_s)" \
  "$(number pressure_slope_Pa_m)" "$slope" "${rms:--}" "$rms_half" "${front:--}"
