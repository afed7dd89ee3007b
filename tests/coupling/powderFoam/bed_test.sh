#!/usr/bin/env bash
# bed_test.sh TEST REPOSITORY BIN WORK: powderFoam with LIGGGHTS on the bed of foam_cases/packed_bed, 1008
# spheres of 1 mm, void fraction 0.4513: how grains are held, what drives a flow, what comes in.
set -euo pipefail
test=$1 root=$2 bin=$3 work=$4/$1
export WM_PROJECT_DIR=${WM_PROJECT_DIR:-/usr/share/openfoam}
export OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1
rm -rf "$work"
mkdir -p "$work"
status=0
failed() { echo "FAILED: $*" >&2; status=1; }
limit_s=60
. "$root/foam_cases/packed_bed/ergun.sh"

new_case() {  # name
  case_dir=$work/$1
  mkdir -p "$case_dir/post"
  cd "$case_dir"
  cp -r "$root"/foam_cases/packed_bed/{0,constant,system,in.packed_bed} .
  sed -i '/^dump/d' in.packed_bed
}
periodic() {
  awk '/^boundary/ { exit } { print }' system/blockMeshDict >mesh
  cat >>mesh <<'DICT'
boundary
(
    zm { type cyclic; neighbourPatch zp; faces ((0 3 2 1)); }
    zp { type cyclic; neighbourPatch zm; faces ((4 5 6 7)); }
    xm { type cyclic; neighbourPatch xp; faces ((0 4 7 3)); }
    xp { type cyclic; neighbourPatch xm; faces ((1 2 6 5)); }
    ym { type cyclic; neighbourPatch yp; faces ((0 1 5 4)); }
    yp { type cyclic; neighbourPatch ym; faces ((3 7 6 2)); }
);
DICT
  mv mesh system/blockMeshDict
  for field in U p; do
    sed -i '/^boundaryField/,$d' "0/$field"
    echo 'boundaryField { ".*" { type cyclic; } }' >>"0/$field"
  done
  sed -i 's/nOuterCorrectors .*/nOuterCorrectors 1; pRefCell 0; pRefValue 0;/' system/fvSolution
  sed -i '/^    inletPressure/,/^    }/d' system/controlDict
  sed -i 's/^boundary .*/boundary p p p/' in.packed_bed
}
driven_by() {  # entries of a source
  printf 'FoamFile { version 2.0; format ascii; class dictionary; object fvOptions; }\ndrive { %s }\n' \
    "$1" >constant/fvOptions
}
functions() {
  local text
  text=$(tr '\n' ' ' <<<"$1")
  sed -i "s|^functions|&\n{ $text|; /^functions/,/^{/ { /^{\$/d }" system/controlDict
}
couple() {  # ranks of each program, transport
  local parallel=
  sed -i "s/^ *transport .*/    transport $2;/" constant/couplingProperties
  blockMesh >log.blockMesh 2>&1
  if [[ $1 == 2 ]]; then
    parallel=-parallel
    decomposePar >log.decomposePar 2>&1
  fi
  local run=(mpirun --oversubscribe --bind-to none --mca mpi_yield_when_idle 1)
  local dem=("$bin/liggghts-powderlink" -in in.packed_bed -var transport "$2")
  if [[ $2 == mpi ]]; then
    timeout $limit_s "${run[@]}" -np "$1" "${dem[@]}" : -np "$1" "$bin/powderFoam" $parallel >log 2>&1 ||
      { tail -n 20 log >&2; failed "$case_dir: exit status $?"; }
  else
    timeout $limit_s "${run[@]}" -np "$1" "$bin/powderFoam" $parallel >log 2>&1 &
    timeout $limit_s "${run[@]}" -np "$1" "${dem[@]}" >log.dem 2>&1 ||
      { tail -n 20 log.dem >&2; failed "$case_dir: LIGGGHTS, exit status $?"; }
    wait $! || { tail -n 20 log >&2; failed "$case_dir: powderFoam, exit status $?"; }
    cat log.dem >>log
  fi
}
close_to() {  # what value reference tolerance (relative)
  echo "$1: $2, expected $3"
  awk -v v="$2" -v r="$3" -v t="$4" 'BEGIN { e = v - r; if (e < 0) e = -e; if (r < 0) r = -r
    exit !(v != "" && e <= t*r) }' || failed "$1: $2, expected $3 within $4"
}
says() { grep -qF -- "$1" log || failed "$case_dir: the log lacks '$1'"; }
last() { awk -v c="$2" '!/^#/ { v = $c } END { gsub(/[()]/, "", v); print v }' "postProcessing/$1"; }

# The bed against Ergun, foam_cases/packed_bed: the mesh resolves it within this.
ergun_tolerance=0.01
# Decompositions differ in the last iterations of the pressure only.
ranks_tolerance=1e-5

case $test in
  held)
    # Whatever holds the grains, and whatever their mass, the gas feels the same bed. Grains of 20 kg/m3
    # would follow it within a thirtieth of an interval.
    ways=("fix hold all freeze|2000|1|mpi" "|20|1|mpi" "fix hold all nve/noforce|7950|2|socket"
      "fix go all nve/sphere\nfix hold all setforce 0 0 0|20|2|mpi")
    for n in "${!ways[@]}"; do
      IFS='|' read -r fixes density ranks transport <<<"${ways[n]}"
      new_case "way_$n"
      sed -i "s|^fix  *hold.*|$fixes|; s/density 2000/density $density/" in.packed_bed
      couple "$ranks" "$transport"
      drop=$(pressure_drop_Pa)
      close_to "drop with '$fixes', $density kg/m3" "$drop" "$(ergun_Pa)" $ergun_tolerance
      [[ $n != 0 ]] || frozen=$drop
      close_to "the same as with freeze" "$drop" "$frozen" $ranks_tolerance
    done
    cd "$work/way_1"
    says "particles that do not move; given: 1008 of 1008 coupled particles"
    ;;
  driven)
    # All sides cyclic. The force on the grains is the driving gradient times the box, and Ergun's; models
    # A and B have the same flow.
    sup='type superficialVelocityForce; superficialVelocity (0 0 2e-3);'
    mean='type meanVelocityForce; active yes; meanVelocityForceCoeffs { selectionMode all; fields (U);
      Ubar (0 0 4.43164e-3); }'
    fixed='type vectorSemiImplicitSource; active yes; vectorSemiImplicitSourceCoeffs { selectionMode all;
      volumeMode specific; injectionRateSuSp { U ((0 0 147.4359) 0); } }'
    # From rest to the same flow.
    rising='type superficialVelocityForce; superficialVelocity table ((0 (0 0 0)) (0.01 (0 0 2e-3)) (1 (0 0 2e-3)));'
    ways=("A|$sup|1|mpi" "B|$sup|2|socket" "A|$mean|2|mpi" "A|$fixed|1|mpi" "A|$rising|1|mpi")
    for n in "${!ways[@]}"; do
      IFS='|' read -r -d '' model source ranks transport <<<"${ways[n]}" || true
      new_case "way_$n"
      periodic
      driven_by "$source"
      sed -i "s/^model .*/model $model;/" constant/couplingProperties
      sed -i 's/^thermo .*/thermo_style custom step f_bridge[3]\nthermo 400/' in.packed_bed
      couple "$ranks" "${transport//[[:space:]]/}"
      force=$(awk '$1 == 400 && NF == 2 { print $2 }' log)
      close_to "force on the grains, model $model, ${source%%;*}" "$force" \
        "$(awk -v p="$(ergun_Pa)" 'BEGIN { print p*7.852353e-3^2 }')" $ergun_tolerance
      gradient=$(awk '/ressure gradient/ && /ncorrected/ { for (i = 1; i < NF; i++)
        if ($i == "gradient") v = $(i + 1) == "=" ? $(i + 2) : $(i + 1) } END { print v }' log)
      # Steady, so that the bed takes all that drives; interpolation to the grains is not conservative.
      close_to "driving gradient times volume" "$(awk -v g="${gradient:-147.4359}" \
        'BEGIN { print 10*g*7.852353e-3^2*15.6e-3 }')" "$force" 2e-3
      says "fvOptions: drive is a mean pressure gradient"
    done
    cd "$work/way_2"
    says "given:   Ubar of meanVelocityForce, which is the mean of U, the velocity between the particles"
    ;;
  momentum)
    # Free grains in a periodic box: the driving gradient gives fluid and grains together its volume times
    # time, and what a scalar fills the fluid with stays there. With 16 grains in each cell of a coarse mesh
    # p is uniform; where it is not, its gradient at the grains is not that of the cells in every digit.
    for ranks in 1 2; do
      new_case "ranks_$ranks"
      periodic
      driven_by 'type vectorSemiImplicitSource; active yes; vectorSemiImplicitSourceCoeffs { selectionMode all;
        volumeMode specific; injectionRateSuSp { U ((30 0 100) 0); } }'
      sed -i 's/density 2000/density 7950/; s/^fix  *hold.*/fix go all nve\/sphere/; s/^run .*/run 150/' in.packed_bed
      sed -i 's/^thermo .*/variable px equal vcm(all,x)*mass(all)\nvariable pz equal vcm(all,z)*mass(all)\nthermo_style custom step v_px v_pz\nthermo_modify format float %.12g\nthermo 10/' in.packed_bed
      sed -i 's/^endTime.*/endTime 0.015;/' system/caseSettings
      sed -i '/^internalField/s/uniform.*/uniform (0 0 0);/' 0/U
      functions 'one { type fluidScalarTransport; field one; D 1e-4; } uneven { type fluidScalarTransport; field uneven; D 1e-4; }
        gas { type volFieldValue; libs (fieldFunctionObjects); regionType all; operation weightedVolIntegrate; weightField alphaf; fields (U uneven); writeFields no; log no; writeControl timeStep; }
        range { type fieldMinMax; libs (fieldFunctionObjects); fields (one); location no; writeControl timeStep; }'
      sed -i 's/^ *default  *none;/default none; div(phi,one) Gauss upwind; div(phi,uneven) Gauss upwind;/' system/fvSchemes
      sed -i 's/"U\.\*"/"(U|one|uneven).*"/' system/fvSolution
      cells=1024 tolerance=2e-3
      if [[ $ranks == 2 ]]; then
        cells=63 tolerance=1e-6
        sed -i 's/^cells.*/cells (3 3 7);/' system/caseSettings
        sed -i 's/^ *voidFraction .*/    voidFraction { type centre; }/' constant/couplingProperties
      fi
      for field in one uneven; do
        echo "FoamFile { version 2.0; format ascii; class volScalarField; object $field; } dimensions [0 0 0 0 0 0 0];"
        if [[ $field == one ]]; then echo "internalField uniform 1;"; else
          awk -v n=$cells 'BEGIN { print "internalField nonuniform List<scalar> " n "("
            for (i = 0; i < n; i++) print 1 + i%7; print ");" }'
        fi
        echo 'boundaryField { ".*" { type cyclic; } }'
      done >fields
      awk '/object uneven/ { on = 1 } { print > (on ? "0/uneven" : "0/one") }' fields
      couple $ranks mpi
      # At the last exchange that the books have, with what is still open in them.
      awk 'FILENAME ~ /volFieldValue/ && !/^#/ { gsub(/[()]/, ""); t = sprintf("%.4f", $1); ux[t] = $2; uz[t] = $4; T[t] = $5; if (!first) first = $5; final = $5 }
        FILENAME == "log" && NF == 3 && $1 ~ /^[0-9]+$/ { px[$1] = $2; pz[$1] = $3 }
        FILENAME == "log" && /^momentum / { gsub(/[()]/, " "); n++; ox = $13; oz = $15 }
        END { step = 10*(n - 1); t = sprintf("%.4f", step*1e-4); V = 7.852353e-3^2*15.6e-3
          printf "%.6g %.6g %.3g\n", (10*ux[t] + px[step] + ox)/(10*30*V*t), (10*uz[t] + pz[step] + oz)/(10*100*V*t), final/first - 1 }' \
        postProcessing/gas/0/volFieldValue.dat log >sums
      read -r x z lost <sums
      [[ $ranks == 1 ]] || close_to "$ranks ranks: momentum along x" "$x" 1 $tolerance
      close_to "$ranks ranks: momentum along z" "$z" 1 $tolerance
      # Written with the fields, not in every step.
      [[ $(find . -maxdepth 2 -path './[0-9]*/uneven' | wc -l) == 2 || $ranks == 2 ]] || failed "fields of every step"
      awk -v l="$lost" 'BEGIN { exit !(l*l < 1e-16) }' || failed "$ranks ranks: scalar lost or gained $lost"
      awk '!/^#/ { n++; if ($2 < 1 - 1e-7 || $3 > 1 + 1e-7) bad++ } END { exit !(n && !bad) }' \
        postProcessing/range/0/fieldMinMax.dat || failed "$ranks ranks: a scalar of 1 did not stay"
    done
    ;;
  inlets)
    # Grains in the inlet. What is asked for comes in, also when it changes in time; a stock condition is
    # warned of; a scalar of 1 stays 1.
    bed_flow='operation sum; regionType patch; name inlet; fields (alphaPhi); writeFields no; log no; writeControl timeStep;'
    for ranks in 1 2; do
      for way in "superficialInletVelocity; volumetricFlowRate table ((0 1e-7) (0.02 1.2e-7)); value uniform (0 0 0);|1.2e-7" \
        "superficialInletVelocity; superficialVelocity (0 0 2e-3);|1.23319e-7" \
        "flowRateInletVelocity; volumetricFlowRate 1e-6; value uniform (0 0 1e-2);|4.1e-7"; do
        [[ $ranks == 1 || $way == superficial*volumetric* ]] || continue
        new_case "inlet_${ranks}_${way:0:1}${way:31:5}"
        sed -i 's/^endTime.*/endTime 0.02;/' system/caseSettings
        sed -i "/^    inlet/,/^    }/c\\    inlet { type ${way%|*} }" 0/U
        functions "flow { type surfaceFieldValue; libs (fieldFunctionObjects); $bed_flow }
          tracer { type fluidScalarTransport; D 1e-5; }
          range { type fieldMinMax; libs (fieldFunctionObjects); fields (T); location no; writeControl timeStep; }"
        sed -i 's/^ *default  *none;/default none; div(phi,T) Gauss upwind;/' system/fvSchemes
        sed -i 's/"U\.\*"/"(U|T).*"/' system/fvSolution
        cat >0/T <<'FIELD'
FoamFile { version 2.0; format ascii; class volScalarField; object T; }
dimensions [0 0 0 0 0 0 0];
internalField uniform 1;
boundaryField { inlet { type fixedValue; value uniform 1; } ".*" { type zeroGradient; } }
FIELD
        couple $ranks mpi
        flow=$(last flow/0/surfaceFieldValue.dat 2)
        # Tables give the stock condition two digits, an area the other one six.
        close_to "flow of ${way%%;*}" "${flow#-}" "${way#*|}" "$([[ $way == flow* ]] && echo 0.02 || echo 1e-5)"
        if [[ $way == flow* ]]; then
          says "Warning: particles in the inlet inlet"
          says "superficialInletVelocity with volumetricFlowRate"
        else
          ! grep -q "particles in the inlet" log || failed "$case_dir: a warning without a reason"
        fi
        awk '!/^#/ { n++; if ($2 < 1 - 1e-6 || $3 > 1 + 1e-6) bad++ } END { exit !(n && !bad) }' \
          postProcessing/range/0/fieldMinMax.dat || failed "$case_dir: a scalar of 1 did not stay"
      done
    done
    ;;
esac
exit $status
