#!/usr/bin/env bash
# powder_foam_test.sh TEST REPOSITORY BIN WORK: tests of powderFoam on a pipe of 1 600 cells.
set -euo pipefail
test=$1 root=$2 bin=$3 work=$4/$1
export WM_PROJECT_DIR=${WM_PROJECT_DIR:-/usr/share/openfoam}
export OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1
rm -rf "$work"
mkdir -p "$work"
status=0
failed() { echo "FAILED: $*" >&2; status=1; }

# The verification case on 10 mm with 10 layers, 10 steps; mesh made once per test.
new_case() {  # name
  case_dir=$work/$1
  mkdir -p "$case_dir"
  cd "$case_dir"
  cp -r "$root"/foam_cases/hagen_poiseuille/{0,constant,system} .
  rm system/caseSettings.short
  cat >system/caseSettings <<'SETTINGS'
pipeLength 0.01; layers 10; endTime 2e-4; deltaT 2e-5;
probeLocations ((0 0 0.0015) (0 0 0.0025) (0 0 0.0075) (0 0 0.0085));
SETTINGS
  # So tight that runs can be compared.
  sed -i -E 's/^( *tolerance  *)1e-[0-9]+;/\11e-11;/; s/^( *relTol  *)0\.[0-9]+;/\10;/' \
    system/fvSolution
  if [[ -d $work/mesh ]]; then
    cp -r "$work/mesh" constant/polyMesh
  else
    blockMesh >log.blockMesh 2>&1
    cp -r constant/polyMesh "$work/mesh"
  fi
}
solve() {
  "$bin/powderFoam" >log 2>&1 || { tail -n 20 log >&2; failed "$case_dir: powderFoam, exit status $?"; }
}
slip_walls() { sed -i 's/noSlip/slip/' 0/U; }
longer() { sed -i 's/endTime 2e-4/endTime 1e-2/; s/deltaT 2e-5/deltaT 2e-4/' system/caseSettings; }
fluid_fraction() {  # uniform value
  cat >0/alphaf <<FIELD
FoamFile { version 2.0; format ascii; class volScalarField; object alphaf; }
dimensions [0 0 0 0 0 0 0];
internalField uniform $1;
boundaryField { ".*" { type zeroGradient; } }
FIELD
}
coupling() {  # entries
  printf 'FoamFile { version 2.0; format ascii; class dictionary; object couplingProperties; }\n%s\n' \
    "$1" >constant/couplingProperties
}
# probe FIELD COLUMN: last value of a probe's scalar, or of its velocity along the pipe
probe() {
  awk -v field="$1" -v column="$2" 'END { gsub(/[()]/, " ");
    print field == "U" ? $(1 + 3*column) : $(1 + column) }' "postProcessing/axis/0/$1"
}
close_to() {  # what value reference tolerance (relative)
  awk -v v="$2" -v r="$3" -v t="$4" 'BEGIN { e = v - r; if (e < 0) e = -e; if (r < 0) s = -r; else s = r
    exit !(v != "" && e <= t*s) }' || failed "$1: $2, expected $3 within $4"
}
slope() { awk -v a="$(probe p 3)" -v b="$(probe p 4)" 'BEGIN { printf "%.10g", (b - a)/0.001 }'; }
refused() {  # what, texts that the message must hold
  local what=$1 code=0
  shift
  "$bin/powderFoam" >log 2>&1 || code=$?
  [[ $code != 0 ]] || failed "$what: accepted"
  for text in "given:" "allowed:" "to do:" "$@"; do
    grep -qF -- "$text" log || failed "$what: the message lacks '$text'"
  done
  [[ -z $(find . -maxdepth 1 -name '0.*' -o -maxdepth 1 -name '*e-*') ]] ||
    failed "$what: fields were written"
}

case $test in
  fluid_fraction)
    # A uniform fluid fraction cancels from model A.
    new_case one; rm constant/couplingProperties; solve
    u=$(probe U 3) p=$(probe p 1)
    new_case half_A; fluid_fraction 0.5; solve
    close_to "model A, velocity" "$(probe U 3)" "$u" 1e-6
    close_to "model A, pressure" "$(probe p 1)" "$p" 1e-6
    # In steady slow flow from model B too, where the fluid has all of grad(p) and of the stress; with
    # drag K_B = K_A/alphaf. What is left of inertia at Re = 5 is less.
    slow_case() {  # name, couplingProperties
      new_case "$1"
      sed -i 's/(0 0 10)/(0 0 0.05)/' 0/U
      sed -i 's/endTime 2e-4/endTime 0.06/; s/deltaT 2e-5/deltaT 4e-4/' system/caseSettings
      fluid_fraction 0.5
      coupling "$2"
      solve
    }
    no_inertia=1e-3
    slow_case slow_A 'model A;'
    u=$(probe U 3) p=$(slope)
    slow_case slow_B 'model B;'
    close_to "model B, velocity" "$(probe U 3)" "$u" $no_inertia
    close_to "model B, pressure gradient" "$(slope)" "$p" $no_inertia
    slow_case drag_A 'model A; particleMomentum { type prescribed; Su (0 0 0); Sp -200; }'
    awk -v a="$u" -v b="$(probe U 3)" 'BEGIN { exit !(b < 0.99*a) }' || failed "drag does not flatten the profile"
    u=$(probe U 3) p=$(slope)
    slow_case drag_B 'model B; particleMomentum { type prescribed; Su (0 0 0); Sp -400; }'
    close_to "model B with drag, velocity" "$(probe U 3)" "$u" $no_inertia
    close_to "model B with drag, pressure gradient" "$(slope)" "$p" $no_inertia
    ;;
  continuity)
    # alphaf falls along the pipe so that U rises from 1 to 2 m/s in ten steps of 1/9: alphaf U is
    # constant, and the pressure falls by Bernoulli with the interstitial velocity (model A).
    new_case nozzle; slip_walls; fluid_fraction 1
    {
      echo 'FoamFile { version 2.0; format ascii; class dictionary; object setFieldsDict; }'
      echo 'defaultFieldValues (); regions ('
      for layer in {0..9}; do
        awk -v i="$layer" 'BEGIN { printf "boxToCell { box (-1 -1 %g) (1 1 1); fieldValues " \
          "( volScalarFieldValue alphaf %.10g ); }\n", 1e-3*i, 1/(1 + i/9) }'
      done
      echo ');'
    } >system/setFieldsDict
    setFields >log.setFields 2>&1
    sed -i 's/(0 0 10)/(0 0 1)/' 0/U
    longer
    solve
    close_to "velocity in layer 2" "$(probe U 1)" 1.1111 0.01
    close_to "velocity in layer 9" "$(probe U 4)" 1.8889 0.01
    close_to "Bernoulli's pressure drop" \
      "$(awk -v a="$(probe p 1)" -v b="$(probe p 4)" 'BEGIN { print a - b }')" 1.16667 0.03
    close_to "continuity error" "$(awk '/^time step cont/ { print 1 + $9 }' log | tail -n 1)" 1 1e-9
    ;;
  momentum_source)
    # Plug flow: share dp/dz = Su + Sp U (+ fvOptions), with U = 10 m/s. Within 0.2 %: the inlet's zero
    # gradient of p disturbs the cells next to it.
    source='particleMomentum { type prescribed; Su (0 0 300); Sp -50; }'
    new_case A; slip_walls; longer; fluid_fraction 0.5; coupling "model A; $source"; solve
    close_to "model A, pressure gradient" "$(slope)" -400 2e-3
    new_case B; slip_walls; longer; fluid_fraction 0.5; coupling "model B; $source"; solve
    close_to "model B, pressure gradient" "$(slope)" -200 2e-3
    new_case options; slip_walls; longer; fluid_fraction 0.5; coupling "model B; $source"
    cat >system/fvOptions <<'DICT'
FoamFile { version 2.0; format ascii; class dictionary; object fvOptions; }
resistance
{
    type            vectorSemiImplicitSource;
    selectionMode   all;
    volumeMode      specific;
    injectionRateSuSp { U ((0 0 0) -20); }
}
DICT
    solve
    close_to "fvOptions, pressure gradient" "$(slope)" -400 2e-3
    ;;
  fluid_fraction_jump)
    # A bed with sharp ends, 3 to 7 mm of the pipe: resistance s in cells of fluid fraction 0.45. In the bed
    # share dp/dz = -s U with U = 1/0.45 m/s. Neither p nor U may alternate from cell to cell.
    for model in A B; do
      new_case "jump_$model"; slip_walls; fluid_fraction 1; coupling "model $model;"
      rm -r constant/polyMesh
      centres=$(for i in {0..39}; do awk -v i="$i" 'BEGIN { printf "(0 0 %.8g) ", 2.5e-4*(i + 0.5) }'; done)
      sed -i -E "s/layers 10;/layers 40;/; s/^probeLocations.*/probeLocations ($centres);/" system/caseSettings
      sed -i 's/endTime 2e-4/endTime 5e-3/; s/deltaT 2e-5/deltaT 5e-5/' system/caseSettings
      sed -i 's/(0 0 10)/(0 0 1)/' 0/U
      blockMesh >log.blockMesh 2>&1
      cat >system/setFieldsDict <<'DICT'
FoamFile { version 2.0; format ascii; class dictionary; object setFieldsDict; }
defaultFieldValues ();
regions ( boxToCell { box (-1 -1 3e-3) (1 1 7e-3); fieldValues ( volScalarFieldValue alphaf 0.45 ); } );
DICT
      cat >system/topoSetDict <<'DICT'
FoamFile { version 2.0; format ascii; class dictionary; object topoSetDict; }
actions ( { name bed; type cellSet; action new; source boxToCell; box (-1 -1 3e-3) (1 1 7e-3); } );
DICT
      cat >system/fvOptions <<'DICT'
FoamFile { version 2.0; format ascii; class dictionary; object fvOptions; }
bed { type vectorSemiImplicitSource; selectionMode cellSet; cellSet bed; volumeMode specific;
  injectionRateSuSp { U ((0 0 0) -2000); } }
DICT
      setFields >log.setFields 2>&1
      topoSet >log.topoSet 2>&1
      solve
      share=$(awk -v m=$model 'BEGIN { print m == "A" ? 0.45 : 1 }')
      for field in p U; do
        awk '!/^#/ { gsub(/[()]/, " "); row = $0 } END { print row }' postProcessing/axis/0/$field >last.$field
      done
      # Cells 12 to 27 are the bed. The ends smear over three cells, with a single overshoot by the
      # linear upwind scheme; 16 to 23 are four cells or more away from them.
      slope=$(awk '{ printf "%.10g", ($(2 + 23) - $(2 + 16))/(7*2.5e-4) }' last.p)
      close_to "model $model, pressure gradient in the bed" "$slope" \
        "$(awk -v a="$share" 'BEGIN { print -2000/0.45/a }')" 0.01
      # Contraction and expansion cancel; what is left of 2 % is the ends' numerical loss.
      close_to "model $model, pressure drop" "$(awk '{ printf "%.10g", $(2 + 11) - $(2 + 28) }' last.p)" \
        "$(awk -v a="$share" 'BEGIN { print 2000/0.45/a*4e-3 }')" 0.02
      # Alternating part: (-1, 2, -1)/4 over three cells, against the drop and the velocity.
      awk -v model=$model '
        function wiggle(field, first, last,  i, w, s) {
          for (i = first; i <= last; i++) {
            s = v[field, i - 1] - 2*v[field, i] + v[field, i + 1]; if (s < 0) s = -s; if (s/4 > w) w = s/4 }
          return w }
        FILENAME == "last.p" { for (i = 0; i < 40; i++) v["p", i] = $(2 + i) }
        FILENAME == "last.U" { for (i = 0; i < 40; i++) v["U", i] = $(4 + 3*i) }
        END { drop = v["p", 11] - v["p", 28]
          p = wiggle("p", 17, 22)/drop; u = wiggle("U", 17, 22)*0.45
          out = wiggle("U", 1, 7)
          for (i = 0; i < 40; i++) if (v["U", i] > top) top = v["U", i]
          printf "model %s: alternating part of p %.2g of the drop, of U %.2g in the bed, %.2g before it; " \
            "largest U %.4g\n", model, p, u, out, top
          exit !(drop > 0 && p < 5e-4 && u < 2e-3 && out < 2e-3 && top < 1.05/0.45) }' last.p last.U ||
        failed "model $model: p or U alternate"
    done
    ;;
  ranks)
    new_case serial; fluid_fraction 0.7; solve
    u=$(probe U 3) p=$(probe p 1)
    new_case parallel; fluid_fraction 0.7
    decomposePar >log.decomposePar 2>&1
    mpirun -np 2 --oversubscribe --bind-to none --mca mpi_yield_when_idle 1 "$bin/powderFoam" -parallel >log 2>&1 ||
      { tail -n 20 log >&2; failed "2 ranks"; }
    close_to "velocity on 2 ranks" "$(probe U 3)" "$u" 1e-7
    close_to "pressure on 2 ranks" "$(probe p 1)" "$p" 1e-7
    ;;
  adjustable_time_step)
    new_case adjust
    sed -i 's/^adjustTimeStep.*/adjustTimeStep yes;/; s/^maxCo .*/maxCo 0.5;/' system/controlDict
    solve
    largest=$(awk '/^Courant Number/ { c = $NF } END { print c }' log)
    close_to "Courant number" "$largest" 0.5 0.25
    [[ -f 0.0002/alphaf && -f 0.0002/U ]] || failed "no fields at the end time"
    ;;
  bad_input)
    new_case bad
    valid='model couplingInterval couplingTime maxCoFatal particleMomentum'
    coupling 'model A; couplingIntervall 2;'
    refused "misspelt entry" couplingIntervall "$valid"
    coupling 'couplingInterval 2;'
    refused "missing entry" "missing entry model" "$valid"
    coupling 'model C;'
    refused "unknown model" "model" "C" "A (pressure gradient"
    coupling 'model A; couplingInterval 0;'
    refused "interval of 0" couplingInterval "at least 1"
    coupling 'model A; maxCoFatal -1;'
    refused "negative Courant limit" maxCoFatal
    coupling 'model A; particleMomentum { type prescibed; }'
    refused "misspelt type" prescibed "none prescribed"
    coupling 'model A; particleMomentum { type prescribed; Su (0 0 1); }'
    refused "missing Sp" "missing entry Sp" "type Su Sp"
    coupling 'model A; particleMomentum { type prescribed; Su (0 0 1); Sp 3; }'
    refused "driving Sp" "at most 0"
    coupling 'model A; particleMomentum { typ prescribed; }'
    refused "no type" "bad value of entry type" "missing" "none prescribed"
    coupling 'model A; maxCoFatal 0.1;'
    refused "Courant number" "Courant number above its limit" "maxCoFatal = 0.1"
    coupling 'model A;'
    for value in 0 1.5 -0.2; do
      fluid_fraction "$value"
      refused "fluid fraction $value" "fluid fraction out of range"
    done
    # All ranks stop.
    rm 0/alphaf
    coupling 'model A; maxCoFatal 0.1;'
    decomposePar >log.decomposePar 2>&1
    code=0
    timeout 20 mpirun -np 2 --oversubscribe --bind-to none --mca mpi_yield_when_idle 1 "$bin/powderFoam" -parallel \
      >log 2>&1 || code=$?
    [[ $code != 0 && $code != 124 ]] || failed "2 ranks: exit status $code"
    grep -qF "Courant number above its limit" log || failed "2 ranks: no message"
    ;;
  left_out)
    # What another solver's case brings along and this one does not do.
    header='FoamFile { version 2.0; format ascii; class dictionary; object x; }'
    new_case left_out
    echo "$header zone { cellZone all; active yes; origin (0 0 0); axis (0 0 1); omega 3; }" >constant/MRFProperties
    echo "$header dynamicFvMesh dynamicMotionSolverFvMesh;" >constant/dynamicMeshDict
    echo "$header solution {}" >constant/kinematicCloudProperties
    echo "$header a {}" >constant/SRFProperties
    echo "$header a {}" >system/fvModels
    option='type vectorSemiImplicitSource; active no; selectionMode all; volumeMode specific; injectionRateSuSp { U ((0 0 1) 0); }'
    echo "$header still { $option }" | tee constant/fvOptions >system/fvOptions
    refused "files of other solvers" "constant/MRFProperties" "dynamicMotionSolverFvMesh" \
      "constant/kinematicCloudProperties" "constant/SRFProperties" "system/fvModels" \
      "constant/fvOptions and system/fvOptions"
    [[ $(grep -c "to do:" log) == 6 ]] || failed "not every file is named once"
    decomposePar >log.decomposePar 2>&1
    code=0
    timeout 20 mpirun -np 2 --oversubscribe --bind-to none --mca mpi_yield_when_idle 1 "$bin/powderFoam" -parallel \
      >log 2>&1 || code=$?
    [[ $code != 0 && $code != 124 ]] || failed "2 ranks: exit status $code"
    grep -qF "constant/SRFProperties" log || failed "2 ranks: no message"

    # Switched off, they do no harm.
    rm constant/{kinematicCloudProperties,SRFProperties} system/{fvModels,fvOptions}
    sed -i 's/active yes/active no/' constant/MRFProperties
    echo "$header dynamicFvMesh staticFvMesh;" >constant/dynamicMeshDict
    solve
    solutions=$(grep -c "Solving for p" log)
    cp 2e-04/U U_PIMPLE 2>/dev/null || cp 0.0002/U U_PIMPLE
    rm -r 2e-04 0.0002 2>/dev/null || true

    # The same by the dictionary of pisoFoam.
    sed -i 's/^PIMPLE/PISO/' system/fvSolution
    solve
    [[ $(grep -c "Solving for p" log) == "$solutions" ]] || failed "PISO: not $solutions pressure solutions"
    cmp -s U_PIMPLE 2e-04/U || cmp -s U_PIMPLE 0.0002/U || failed "PISO: another velocity"
    rm -r 2e-04 0.0002 2>/dev/null || true
    sed -i 's/^PISO/SIMPLE/' system/fvSolution
    refused "SIMPLE alone" "system/fvSolution" "PIMPLE or PISO"
    echo 'PIMPLE { nCorrectors 2; nCorrector 3; }' >>system/fvSolution
    solve
    for text in "given:   PIMPLE and SIMPLE" "given:   nCorrector" "nOuterCorrectors"; do
      grep -qF -- "$text" log || failed "warnings of fvSolution: no '$text'"
    done
    rm -r 2e-04 0.0002 2>/dev/null || true

    # Entries of what is ours.
    echo "$header drive { type superficialVelocityForce; }" >constant/fvOptions
    refused "no velocity to drive to" "superficialVelocity" "add superficialVelocity (0 0 0.1);"
    rm constant/fvOptions
    sed -i '/^    inlet/,/^    }/c\    inlet { type superficialInletVelocity; superficialVelocity (0 0 1); volumetricFlowRate 1e-6; }' 0/U
    refused "two flows at an inlet" "superficialVelocity and volumetricFlowRate"
    ;;
  *)
    echo "unknown test: $test" >&2
    exit 2
    ;;
esac
exit $status
