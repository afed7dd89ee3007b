#!/usr/bin/env bash
# The glass capillary of the experiment at 0.2 to 1.0 L/min: nitrogen alone, then with powder.
# run.sh [--short] [--flow Q] [--inlet plug|parabolic] [--powder-velocity V] [--powder-flow G]
#        [--end-time T] [--ranks N] [--dem-ranks N] [--transport mpi|socket] [--out DIR]
#   --flow Q              powder in this flow only [L/min] (all five; --short: 0.8)
#   --inlet               how the gas enters where the powder is (plug); alone it does both
#   --powder-velocity V   of the powder at the entry [m/s] (that of the gas)
#   --powder-flow G       [g/s] (0.03)
set -euo pipefail
cd "$(dirname "$0")"
. ../../scripts/foam_case.sh

flows=(0.2 0.4 0.6 0.8 1.0)
powder_flows=() inlet=plug entry_m_s='' powder_g_s=0.03 end_time='' others=()
while [[ $# -gt 0 ]]; do
  case $1 in
    --flow | --inlet | --powder-velocity | --powder-flow | --end-time)
      [[ $# -ge 2 ]] || foam_case_fail "option without a value" "$1" "$1 VALUE" "add the value"
      case $1 in
        --flow) powder_flows=("$2") ;;
        --inlet) inlet=$2 ;;
        --powder-velocity) entry_m_s=$2 ;;
        --powder-flow) powder_g_s=$2 ;;
        --end-time) end_time=$2 ;;
      esac
      shift 2 ;;
    *) others+=("$1"); shift ;;
  esac
done
calculate() { awk "BEGIN { printf \"%.10g\", $1 }"; }
holds() { awk "BEGIN { exit !($1) }"; }
positive() {  # option, value, unit
  [[ $2 =~ ^([0-9]+\.?[0-9]*|\.[0-9]+)(e[-+]?[0-9]+)?$ ]] && holds "$2 > 0" ||
    foam_case_fail "bad value of $1" "$2" "a number above 0 $3" "correct $1"
}
[[ $inlet == plug || $inlet == parabolic ]] ||
  foam_case_fail "unknown inlet of the gas" "$inlet" "plug, parabolic" "correct --inlet"
if [[ ${#powder_flows[@]} -gt 0 && " ${flows[*]} " != *" ${powder_flows[0]} "* ]]; then
  foam_case_fail "unknown flow" "${powder_flows[0]} L/min" "${flows[*]}" "correct --flow"
fi
[[ -z $entry_m_s ]] || positive --powder-velocity "$entry_m_s" m/s
positive --powder-flow "$powder_g_s" g/s
[[ -z $end_time ]] || positive --end-time "$end_time" s
foam_case_options "${others[@]+"${others[@]}"}"
foam_case_need liggghts-powderlink
if [[ ${#powder_flows[@]} -eq 0 ]]; then
  powder_flows=("${flows[@]}")
  if [[ $short == yes ]]; then powder_flows=(0.8); fi
fi

native=$PWD
density=1.145       # kg/m3, as in constant/transportProperties
viscosity=1.78e-5   # Pa s
powder_density=7980 # kg/m3
dt=4e-7             # s, of LIGGGHTS, as in in.capillary
most_share=0.2      # of the entry's volume: grains that come at random find a place
pi=3.14159265358979
radius=$(foam_case_entry system/caseSettings pipeRadius)
pipe_length=$(foam_case_entry system/caseSettings pipeLength)
mean_m_s() { calculate "$1/60000/($pi*$radius^2)"; }  # of the gas, flow [L/min]

powder=$("$native/make_powder.sh" 45 106 "$powder_density")
grain() { awk -v name="$1" '$2 == name { print $4 }' <<<"$powder"; }
rate=$(calculate "$powder_g_s*1e-3/$(grain grainMass)")
check_powder() {  # flow
  local share fastest entry=${entry_m_s:-$(mean_m_s "$1")}
  # The feed of in.capillary: the section less a grain's radius at the wall.
  share=$(calculate "$powder_g_s*1e-3/($powder_density*$entry*$pi*($radius - $(grain largestGrain))^2)")
  holds "$share <= $most_share" || foam_case_fail "the powder does not fit into the entry" \
    "$powder_g_s g/s at $entry m/s fill $share of its section" "at most $most_share, for grains placed at random" \
    "lower --powder-flow, or raise --powder-velocity"
  fastest=$(calculate "0.9*$(grain smallestGrain)/$dt")
  holds "$entry < $fastest" || foam_case_fail "the powder is too fast for the time step of LIGGGHTS" \
    "$entry m/s" "below $fastest m/s, 0.9 radii of the smallest grain in $dt s" "lower --powder-velocity"
}
for flow in "${powder_flows[@]}"; do check_powder "$flow"; done

copy_case() {  # folder, inlet of the gas, its flow [L/min]; sets gas_m_s
  cd "$native"
  case_copy=$1 foam_case_copy
  # Mesh, solver and walls are those of the other pipes; the size is this one's.
  cp "$native"/../hagen_poiseuille/system/{blockMeshDict,fvSchemes,decomposeParDict} system
  cp "$native"/../hagen_poiseuille/constant/turbulenceProperties constant
  cp "$native"/../pipe/system/{controlDict,functions,fvSolution} system
  cp "$native"/../pipe/0/p 0
  cp "$native"/../pipe/constant/g constant
  cp "system/inlet.$2" system/inlet
  gas_m_s=$(mean_m_s "$3")
  foam_case_set system/caseSettings inletVelocity "$gas_m_s"
  foam_case_set system/functions functions/wallForce/rhoInf "$density"
  [[ -z $end_time ]] || foam_case_set system/caseSettings endTime "$end_time"
}

make_mesh() {
  local other_radius scale
  if [[ -d $out/mesh ]]; then
    cp -r "$out/mesh" constant/polyMesh
    return
  fi
  foam_case_run blockMesh
  other_radius=$(foam_case_entry system/blockMeshDict R)
  scale=$(calculate "$radius/$other_radius")
  foam_case_run transformPoints -scale "($scale $scale 1)"
  # Cells numbered along the pipe: the pressure solver is a third faster.
  foam_case_run renumberMesh -overwrite
  cp -r constant/polyMesh "$out/mesh"
}

# Steady flow of the gas alone, by OpenFOAM's own solver.
run_gas() {  # inlet, flow; adds a line to gas.csv
  local reynolds entrance_m developed fitted window drop loss shah
  copy_case "gas_$1_$2" "$1" "$2"
  cp "$native"/../pipe/steady/* system
  make_mesh
  foam_case_run simpleFoam
  grep -q 'SIMPLE solution converged' log.simpleFoam || foam_case_fail "the gas alone is not steady" \
    "$1, $2 L/min" "convergence within 500 iterations" "see $PWD/log.simpleFoam"
  read -r reynolds entrance_m developed fitted window drop loss shah < <(
    awk -v velocity="$gas_m_s" -v pipe_length="$pipe_length" -v radius="$radius" -v density="$density" \
      -v viscosity="$viscosity" -f "$native/gas.awk" postProcessing/inletPressure/0/surfaceFieldValue.dat \
      postProcessing/axis/0/p) || true
  echo "$2,$1,$gas_m_s,$reynolds,$entrance_m,$developed,$fitted,$window,$drop,$loss,$shah" >>"$out/gas.csv"
  # Behind half of the length a parabola is developed, and a plug where two entrance lengths lie before it.
  if [[ $1 == parabolic ]] || holds "2*$entrance_m < $pipe_length/2"; then
    foam_case_result "slope_$1_$2" Pa/m "$fitted" "$developed" 0.005 "Hagen-Poiseuille: 32 mu U/D^2, $2 L/min"
  fi
  if [[ $1 == plug ]]; then
    foam_case_result "entrance_loss_$2" Pa "$loss" "$shah" 0.024 \
      "Shah 1978: pressure drop above Hagen-Poiseuille, $2 L/min; tolerance: his accuracy"
  fi
}

start_powder() {  # flow; sets entry [m/s], end_s, dem_steps, every: steps from exchange to exchange
  copy_case "powder_$1" "$inlet" "$1"
  make_mesh
  foam_case_run mapFields "../gas_${inlet}_$1" -consistent -sourceTime latestTime
  # Contacts with walls, sums of forces and the outlet are those of the pipe; its points of injection are
  # not used.
  cp "$native"/../pipe/in.{contact.hertz,forces} .
  "$native"/../pipe/make_stl.sh stl 9e-4 1.2e-4
  echo "$powder" >in.powder
  entry=${entry_m_s:-$gas_m_s}
  end_s=$(foam_case_entry system/caseSettings endTime)
  dem_steps=$(calculate "int($end_s/$dt + 0.5)")
  every=$(calculate "int($(foam_case_entry system/caseSettings deltaT)/$dt + 0.5)")
}

run_powder() {  # flow; adds a line to window.csv
  local missing lines injected counts=post/particle_count.csv seen flow_kg_s flow_error fed
  start_powder "$1"
  foam_case_couple in.capillary -var length "$pipe_length" -var rate "$rate" -var inletSpeed "$entry" \
    -var every "$every" -var steps "$dem_steps"
  foam_case_grain_steps "$dt" post/particles_*.dump
  missing=$(awk -F, 'NR > 1 { m = $5 < 0 ? -$5 : $5; if (m > most) most = m }
    END { print (NR > 1 ? most + 0 : "none") }' $counts)
  foam_case_result "particles_missing_$1" 1 "$missing" 0 0 "inserted = inside + escaped, at every 100 us"
  lines=$(awk 'END { print NR - 1 }' $counts)
  foam_case_result "counts_written_$1" 1 "$lines" "$(calculate "int($end_s/1e-4 + 0.5)")" 0 \
    "a line at every 100 us"
  injected=$(awk -F, 'END { print $2 }' $counts)
  # Each insertion rounds a number at random: less scatter than that of as many independent grains.
  foam_case_result "injection_rate_$1" 1/s "$(calculate "$injected/$end_s")" "$rate" \
    "$(calculate "3/sqrt($injected)")" "given; three standard errors"
  fed=$(awk -F, -v t="$end_s" 'END { printf "%.6g", $6/t }' $counts)
  # The second half of the run is its result.
  seen=$(awk -v from="$((dem_steps/2))" -v last="$dem_steps" -v radius="$radius" -f "$native/window.awk" \
    post/window.dump) || foam_case_fail "no grain was in the window" "$end_s s at $entry m/s" \
    "a run in whose second half grains pass half of the length" "raise --end-time"
  read -r flow_kg_s flow_error < <(cut -d ' ' -f 9,10 <<<"$seen") || true
  foam_case_result "window_flow_$1" kg/s "$flow_kg_s" "$fed" "$(calculate "3*$flow_error/$fed")" \
    "mass that was fed: what passes the window when the flow is steady; three standard errors"
  foam_case_closure "exchange_closure_$1"
  echo "$1,$gas_m_s,$entry,$rate,${seen// /,},$fed" >>"$out/window.csv"
}

mkdir -p "$out"
rm -rf "$out/mesh"
printf '%s,' flow_L_min inlet velocity_m_s reynolds entrance_length_m hagen_poiseuille_Pa_m slope_Pa_m \
  window_slope_Pa_m drop_Pa entrance_loss_Pa | sed 's/$/shah_entrance_loss_Pa\n/' >"$out/gas.csv"
for flow in "${flows[@]}"; do
  for kind in parabolic plug; do run_gas "$kind" "$flow"; done
done
column -s, -t "$out/gas.csv"
printf '%s,' flow_L_min gas_m_s entry_m_s rate_1_s frames grains_per_frame velocity_mean_m_s \
  velocity_mean_error_m_s velocity_std_m_s height_mean_m height_mean_error_m height_std_m mass_flow_kg_s \
  mass_flow_error_kg_s | sed 's/$/fed_kg_s\n/' >"$out/window.csv"
for flow in "${powder_flows[@]}"; do run_powder "$flow"; done
column -s, -t "$out/window.csv"
foam_case_write capillary
