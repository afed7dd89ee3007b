#!/usr/bin/env bash
# Metal powder in a pipe: steady flow of the gas alone, then gas and powder.
# run.sh [--short] [--filled] [--case A|B] [--inputs source|assumed] [--set NAME=VALUE]...
#        [--contact hertz|jkr] [--end-time T] [--continue] [--write-interval T] [--ranks N] [--dem-ranks N]
#        [--transport mpi|socket] [--out DIR]
set -euo pipefail
cd "$(dirname "$0")"
. ../../scripts/foam_case.sh
. ./inputs.sh

flow='' variant='' settings=() contact=hertz end_time='' write_interval='' filled=no go_on=no others=()
while [[ $# -gt 0 ]]; do
  case $1 in
    --filled) filled=yes; shift ;;
    --continue) go_on=yes; shift ;;
    --case | --inputs | --set | --contact | --end-time | --write-interval)
      [[ $# -ge 2 ]] || foam_case_fail "option without a value" "$1" "$1 VALUE" "add the value"
      case $1 in
        --case) flow=$2 ;;
        --inputs) variant=$2 ;;
        --set) settings+=("$2") ;;
        --contact) contact=$2 ;;
        --end-time) end_time=$2 ;;
        --write-interval) write_interval=$2 ;;
      esac
      shift 2 ;;
    *) others+=("$1"); shift ;;
  esac
done
[[ $contact == hertz || $contact == jkr ]] ||
  foam_case_fail "unknown contact model" "$contact" "hertz, jkr" "correct --contact"
for time in "$end_time" "$write_interval"; do
  [[ -z $time || $time =~ ^[0-9.]+(e-?[0-9]+)?$ ]] ||
    foam_case_fail "bad time" "$time" "seconds" "correct --end-time or --write-interval"
done
foam_case_options "${others[@]+"${others[@]}"}"
foam_case_need liggghts-powderlink
case ${variant:-source} in
  source | assumed) ;;
  *) foam_case_fail "unknown inputs" "$variant" "source, assumed" "correct --inputs" ;;
esac

native=$PWD
setting() { foam_case_entry system/caseSettings "$1"; }
calculate() { awk "BEGIN { printf \"%.10g\", $1 }"; }

set_times() {
  [[ -z $end_time ]] || foam_case_set system/caseSettings endTime "$end_time"
  [[ -z $write_interval ]] || foam_case_set system/caseSettings writeInterval "$write_interval"
}

copy_case() {
  # The mesh and what belongs to it are those of the pipe without powder.
  cd "$native"
  foam_case_copy
  cp "$native"/../hagen_poiseuille/system/{blockMeshDict,fvSchemes,decomposeParDict} system
  cp "$native"/../hagen_poiseuille/constant/turbulenceProperties constant
  foam_case_set system/caseSettings inletVelocity "${input[gasSpeed]}"
}

# Steady flow of the gas alone, by OpenFOAM's own solver.
start_gas() {
  case_copy=gas copy_case
  cp "$native"/steady/* system
  foam_case_run blockMesh
  # Cells numbered along the pipe: the pressure solver is a third faster.
  foam_case_run renumberMesh -overwrite
  foam_case_run simpleFoam
  grep -q 'SIMPLE solution converged' log.simpleFoam || foam_case_fail "the gas alone is not steady" \
    "the settings in steady/" "convergence within 500 iterations" "see $PWD/log.simpleFoam"
  empty_pressure=$(awk 'END { print $2 }' postProcessing/inletPressure/0/surfaceFieldValue.dat)
  # Developed behind 0.2 m.
  empty_slope_Pa_m=$(awk -v density="$density" -v from=0.199 -f "$native/slope.awk" \
    postProcessing/axis/0/p | awk '{ slope = $2 } END { print (NR ? slope : "none") }')
}

# The steady gas is time 0 of gas and powder.
start_coupled() {
  case_copy=case copy_case
  set_times
  foam_case_set constant/couplingProperties model "${input[model]}"
  foam_case_set constant/couplingProperties particleMomentum/forces "(${input[forces]})"
  pipe_inputs_write in.inputs
  cp "$powder" in.powder
  rm "$powder"
  "$native"/make_stl.sh stl "${input[diskDiameter]}" "${input[pitch]}"
  cp -r ../gas/constant/polyMesh constant
  foam_case_run mapFields ../gas -consistent -sourceTime latestTime
}

# Mean of a column (x y z without brackets) over the times after a given one. A continued run has a
# folder for each of its parts: the later part wins, as the end of an earlier one may be cut off. One
# that starts at the time of an earlier part writes NAME_TIME beside it.
mean_after() {  # function object, file, column, time
  local parts
  parts=$(find "postProcessing/$1" -name "${2%.*}*.${2##*.}" | LC_ALL=C sort -t/ -k3,3g -k4)
  # shellcheck disable=SC2086  # names of our own, without blanks
  awk -v column="$3" -v from="$4" '
    /^#/ { next }
    { gsub(/[()]/, " ") }
    !columns { columns = NF }
    NF == columns && $1 > from { value[$1] = $column }
    END { for (time in value) { sum += value[time]; n++ } if (n) printf "%.9g", sum/n }' $parts
}

density=1.6355      # kg/m3, as in constant/transportProperties

if [[ $go_on == yes ]]; then
  foam_case_need powderlink
  [[ -d $out/case/post ]] || foam_case_fail "there is no run to continue" "$out/case" \
    "a folder in which run.sh has run" "leave --continue out, or correct --out"
  foam_case_wait_for_programs "$out/case"
  cd "$out/case"
  pipe_inputs_read in.inputs
  [[ -z $variant && ${#settings[@]} == 0 && ( -z $flow || $flow == "${input[flow]}" ) ]] ||
    foam_case_fail "a run keeps its inputs" "--inputs, --set or another --case beside --continue" \
      "--continue alone, of case ${input[flow]}" "leave them out, or begin a run in another --out"
  foam_case_run "$foam_case_bin/powderlink" restart . --dt "${input[dt]}" --prepare --json restart.json
  from_s=$(sed -n -E 's/.*"time_s": *([^,]*),.*/\1/p' restart.json)
  # What the first run has written after that time is written again.
  awk -F, -v from="$from_s" -v dt="${input[dt]}" \
    'NR == 1 || (NF == 9 && $1 <= from + dt/2)' post/particle_count.csv >post/count.part
  mv post/count.part post/particle_count.csv
  set_times
  ranks=1
  if [[ -d processor0 ]]; then ranks=$(find . -maxdepth 1 -name 'processor[0-9]*' | wc -l); fi
  foam_case_decompose() { :; }
  read -r fill_count empty_pressure empty_slope_Pa_m <start.txt
else
  powder=$(mktemp)
  trap 'rm -f "$powder"' EXIT
  pipe_inputs_read "inputs/${variant:-source}"
  pipe_inputs_set ${settings[@]+"${settings[@]}"}
  pipe_inputs_derive "${flow:-A}" "$powder"
  start_gas
  start_coupled
  fill_count=0
  if [[ $short == yes || $filled == yes ]]; then
    # 16 600 grains in 300 mm: what case A holds after 0.1 s.
    fill_count=$(calculate "int(16600*$(setting pipeLength)/0.3 + 0.5)")
  fi
  echo "$fill_count $empty_pressure $empty_slope_Pa_m" >start.txt
fi

# Two ranks of LIGGGHTS halve the box: behind 0.2 m are as many grains as before, once the pipe has jammed.
beyond=0
if [[ $dem_ranks == 2 && $short == no ]]; then beyond=0.1; fi

end_s=$(setting endTime)
rate_per_s=${input[rate]} gas_m_s=${input[gasSpeed]}
steps=$(calculate "int($end_s/${input[dt]} + 0.5)")
foam_case_couple in.pipe -var length "$(setting pipeLength)" -var contact "$contact" \
  -var fillCount "$fill_count" -var restart "$([[ $go_on == yes ]] && echo 1 || echo 0)" \
  -var steps "$steps" -var beyond "$beyond"

foam_case_grain_steps "${input[dt]}" post/particles_*.dump
counts=post/particle_count.csv
# A continued run writes the title again.
awk 'NR == 1 || !/^time_s/' $counts >post/count.part
mv post/count.part $counts
# Conservation: the largest imbalance of all lines.
missing=$(awk -F, 'NR > 1 { m = $5 < 0 ? -$5 : $5; if (m > most) most = m } END { print (NR > 1 ? most + 0 : "none") }' $counts)
foam_case_result particles_missing 1 "$missing" 0 0 "inserted = inside + escaped, at every 100 us"
lines=$(awk 'END { print NR - 1 }' $counts)
foam_case_result counts_written 1 "$lines" "$(calculate "int($end_s/1e-4 + 0.5)")" 0 "a line at every 100 us"
injected=$(awk -F, -v fill="$fill_count" 'END { print $2 - fill }' $counts)
foam_case_result injection_rate 1/s "$(calculate "$injected/$end_s")" "$rate_per_s" 0.005 "given"
# Three standard deviations of the mean of all grains.
foam_case_result injected_mass_rate kg/s \
  "$(awk -F, -v t="$end_s" 'END { printf "%.6g", $6/t }' $counts)" \
  "$(calculate "$rate_per_s*${input[grainMass]}")" \
  "$(calculate "3*${input[grainSpread]}/sqrt($injected) + 0.001")" \
  "rate times mean mass of in.powder, statistical error"

# Momentum of the gas along the pipe, mean of the last half: pressure = wall + powder + outflow - inflow.
# (An incompressible gas that flows at a given rate keeps its momentum.)
from_s=$(calculate "$end_s/2 + 1e-8")
pressure=$(mean_after inletPressure surfaceFieldValue.dat 2 "$from_s")
inflow=$(mean_after inletMomentum surfaceFieldValue.dat 4 "$from_s")
outflow=$(mean_after outletMomentum surfaceFieldValue.dat 4 "$from_s")
wall_N=$(mean_after wallForce force.dat 4 "$from_s")
powder_N=$(awk -F, -v from="$from_s" 'NR > 1 && $1 > from { sum += $9; n++ } END { printf "%.9g", sum/n }' $counts)
area=$(calculate "-($inflow)/$gas_m_s^2")
foam_case_result force_of_pressure N "$(calculate "$density*$pressure*$area")" \
  "$(calculate "$wall_N + $powder_N + $density*($outflow + $inflow)")" 0.02 \
  "momentum of the gas: wall, powder, outflow - inflow"
excess=$(calculate "($pressure - $empty_pressure)*$density")
echo "pressure drop above that of the empty pipe: $excess Pa; force of the gas on the powder over the" \
  "section: $(calculate "$powder_N/$area") Pa"
if [[ $empty_slope_Pa_m != none ]]; then
  foam_case_result empty_pressure_slope Pa/m "$empty_slope_Pa_m" "$(calculate "463.3*$gas_m_s")" \
    0.005 "Hagen-Poiseuille: 32 mu U/D^2"
fi
foam_case_write pipe
