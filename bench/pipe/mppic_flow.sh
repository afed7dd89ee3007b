#!/usr/bin/env bash
# bench/pipe/mppic_flow.sh [--case A|B] [--end-time S] [--step S] [--mppic PROGRAM] [--out DIR]: what MP-PIC
# makes of the pipe with the inputs of its source (inputs/source: injection, grains, contact with the wall),
# from the empty pipe on one rank, with the steady gas, mesh and pressure solver of foam_cases/pipe.
#   --step      of gas and cloud; 5e-6 s (A), 1e-5 s (B), those of the source, unless given
#   --end-time  0.2 s (A), 0.4 s (B); its second half is measured
#   --mppic     built by build_mppic.sh unless given, as the packaged program diverges on this mesh
# Prints, and leaves in DIR/mppic.csv: grains in the pipe, their velocity beyond 0.2 m, the pressure slope
# there, the flow through the outlet, its rms after a moving average of 2 ms (window after window) and what
# independent grains alone would give, sqrt((1 + c^2)/(r w)), c the spread of their masses.
set -euo pipefail
caller=$PWD
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
root=$(cd "$here/../.." && pwd)
pipe=$root/foam_cases/pipe
. "$root/scripts/foam_case.sh"
. "$pipe/inputs.sh"

flow=A end_s='' step_s='' mppic='' out=''
while [[ $# -gt 0 ]]; do
  [[ $# -ge 2 ]] || foam_case_fail "option without a value" "$1" "$1 VALUE" "add the value"
  case $1 in
    --case) flow=$2 ;;
    --end-time) end_s=$2 ;;
    --step) step_s=$2 ;;
    --mppic) mppic=$2 ;;
    --out) out=$(cd "$caller" && realpath -m -- "$2") ;;
    *) foam_case_fail "unknown option" "$1" "--case, --end-time, --step, --mppic, --out" "correct it" ;;
  esac
  shift 2
done
[[ $flow == A || $flow == B ]] || foam_case_fail "unknown case" "$flow" "A, B" "correct --case"
for time in "$end_s" "$step_s"; do
  [[ -z $time || $time =~ ^[0-9.]+(e-?[0-9]+)?$ ]] ||
    foam_case_fail "bad time" "$time" "seconds" "correct --end-time or --step"
done
end_s=${end_s:-$([[ $flow == A ]] && echo 0.2 || echo 0.4)}
step_s=${step_s:-$([[ $flow == A ]] && echo 5e-6 || echo 1e-5)}
out=${out:-$pipe/results/mppic_$flow}
if [[ -z $mppic ]]; then
  mppic=$root/build/mppic/MPPICFoam
  "$here/build_mppic.sh" "$root/build/mppic"
fi
limit_s=36000  # 10 000 parcels take some 20 s per ms of 5 us steps

# Mesh, steady gas, powder and points are those of the case; two exchanges of it make them.
mkdir -p "$out"
"$pipe/run.sh" --case "$flow" --end-time 0.0002 --out "$out/start" >"$out/log" 2>&1 || true
[[ -f $out/start/case/in.inputs ]] || { cat "$out/log" >&2; exit 1; }
pipe_inputs_read "$out/start/case/in.inputs"
from=$out/start/case case=$out/case
rm -rf "$case"
mkdir -p "$case"
cp -r "$here"/stock/* "$case"
cp "$here"/MPPICFoam/constant/* "$case/constant"
cp "$from"/system/{caseSettings,blockMeshDict,fvSolution} "$case/system"
cp -r "$from/constant/polyMesh" "$case/constant"
cd "$case"
LC_ALL=C sed 's/object  *U;/object      U.air;/' "$from/0/U" >0/U.air
cp "$from/0/p" 0/p

cloud=constant/kinematicCloudProperties
foam_case_set $cloud constantProperties/rho0 "${input[density]}"
foam_case_set $cloud constantProperties/youngsModulus "${input[youngsModulus]}"
sed -i -E "s/^( +e +)0\.9;/\1${input[restitution]};/; s/^( +mu +)0\.3;/\1${input[friction]};/" $cloud
# Every point of the disk, 1 mm behind the inlet, as many grains from each; OpenFOAM draws their sizes by
# number, from the smallest grain on.
points=$(awk '/outer loop/ { n++ } /vertex/ { x[n] += $2/3; y[n] += $3/3 }
  END { for (i = 1; i <= n; i++) printf "((%.9g %.9g 1e-3) (0 0 1)) ", x[i], y[i] }' "$from/stl/sites.stl")
scale_m=$(sed -n -E 's/^# Made .* x0 ([0-9.]+) um.*/\1e-6/p' "$from/in.powder")
number=$(grep -o '(0 0 1)' <<<"$points" | wc -l)
foam_case_set $cloud subModels/injectionModels "{ disk { type coneInjection; positionAxis ($points);
  massTotal $(pipe_calculate "grainMass*rate*$end_s"); duration $end_s; SOI 0; flowRateProfile constant 1;
  parcelsPerInjector $(pipe_calculate "int(rate*$end_s/$number + 0.5)"); parcelBasisType fixed; nParticle 1;
  Umag constant ${input[inletSpeed]}; thetaInner constant 0; thetaOuter constant 0;
  sizeDistribution { type RosinRammler; RosinRammlerDistribution {
    minValue 40e-6; maxValue 110e-6; d $scale_m; n ${input[sizeExponent]}; } } } }"
control=system/controlDict
foam_case_set $control application MPPICFoam
foam_case_set $control deltaT "$step_s"
foam_case_set $control endTime "$end_s"
foam_case_set $control writeControl runTime
foam_case_set $control writeInterval "$(pipe_calculate "$end_s/100")"
foam_case_set $control purgeWrite 0
foam_case_set $control OptimisationSwitches '{ writeLagrangianPositions 1; }'
cat >>$control <<TEXT
functions
{
    axis
    {
        type                probes;
        libs                (sampling);
        fields              (p);
        writeControl        timeStep;
        writeInterval       20;
        interpolationScheme cellPoint;
        probeLocations      $(foam_case_entry system/caseSettings probeLocations);
    }
}
TEXT
timeout "$limit_s" "$mppic" >log.solver 2>&1 || { tail -n 20 log.solver >&2; exit 1; }

half_s=$(pipe_calculate "$end_s/2")
# time, grains, mass that has left, once a step
awk '
  /^Time = / { time = $3 }
  /Current number of parcels/ { grains = $NF }
  /- escape / { gsub(/,/, ""); print time, grains, $NF }' log.solver >counts
velocity() {  # of the grains beyond 0.2 m: mean and standard deviation over the written times
  local time
  for time in $(foamListTimes); do
    awk -v t="$time" -v from="$half_s" 'BEGIN { exit !(t > from) }' || continue
    paste -d ' ' "$time"/lagrangian/kinematicCloud/{positions,U}
  done | tr -d '()' | awk 'NF == 7 && $3 > 0.2 { n++; sum += $7; square += $7^2 }
    END { if (n) printf "%.4g %.3g", sum/n, sqrt(square/n - (sum/n)^2); else print "- -" }'
}
slope=$(awk -v density=1.6355 -v from=0.2 -f "$pipe/slope.awk" postProcessing/axis/0/p |
  awk -v from="$half_s" '$1 > from { sum += $2; n++ } END { if (n) printf "%.5g", sum/n; else print "-" }')
{
  echo case,method,grains,velocity_m_s,velocity_std_m_s,slope_Pa_m,outlet_flow_g_s,outlet_rms_percent,floor_percent
  read -r mean spread < <(velocity)
  awk -v from="$half_s" -v window=0.002 -v flow="$flow" -v velocity="$mean,$spread" -v slope="$slope" \
    -v rate="${input[rate]}" -v c="${input[grainSpread]}" '
    $1 <= from { next }
    { grains += $2; n++ }
    !w || $1 >= edge - 1e-9 { if (w) share[w] = $3 - before; w++; before = $3; edge = $1 + window }
    END {
      for (i = 1; i < w; i++) mean += share[i]/(w - 1)
      for (i = 1; i < w; i++) square += (share[i] - mean)^2/(w - 2)
      printf "%s,MP-PIC,%.0f,%s,%s,%.4g,%s,%.3g\n", flow, grains/n, velocity, slope, 1e3*mean/window,
        (mean > 0 ? sprintf("%.3g", 100*sqrt(square)/mean) : "-"), 100*sqrt((1 + c^2)/(rate*window))
    }' counts
} | tee "$out/mppic.csv"
