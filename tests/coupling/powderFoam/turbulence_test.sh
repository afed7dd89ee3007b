#!/usr/bin/env bash
# turbulence_test.sh TEST ROOT BIN WORK: turbulence models of powderFoam, against pisoFoam and closed forms.
set -euo pipefail
test=$1 root=$2 bin=$3 work=$4/turbulence_$1
export WM_PROJECT_DIR=${WM_PROJECT_DIR:-/usr/share/openfoam}
rm -rf "$work"
mkdir -p "$work"
status=0
failed() { echo "FAILED: $*" >&2; status=1; }

dictionary() { # FILE ENTRIES
  printf 'FoamFile { version 2.0; format ascii; class dictionary; object %s; }\n%s\n' \
    "$(basename "$1")" "$2" >"$1"
}
scalar_field() { # NAME DIMENSIONS INTERNAL PATCHES
  printf 'FoamFile { version 2.0; format ascii; class volScalarField; object %s; }\n' "$1" >"0/$1"
  printf 'dimensions %s;\ninternalField %s;\nboundaryField { %s }\n' "$2" "$3" "$4" >>"0/$1"
}
dim_k='[0 2 -2 0 0 0 0]' dim_epsilon='[0 2 -3 0 0 0 0]' dim_omega='[0 0 -1 0 0 0 0]' dim_nut='[0 2 -1 0 0 0 0]'
solver=powderFoam
solve() {
  local program=$bin/powderFoam
  [[ $solver == powderFoam ]] || program=$solver
  "$program" >log 2>&1 || { tail -n 20 log >&2; failed "$case_dir: $solver, exit status $?"; }
}

# The pipe of hagen_poiseuille, 10 mm with 10 layers: 10 steps with wall functions.
new_pipe() { # NAME RAS|LES MODEL
  case_dir=$work/$1
  mkdir -p "$case_dir"
  cd "$case_dir"
  cp -r "$root"/foam_cases/hagen_poiseuille/{0,constant,system} .
  rm constant/couplingProperties
  cat >system/caseSettings <<'SETTINGS'
pipeLength 0.01; layers 10; endTime 2e-4; deltaT 2e-5; probeLocations ((0 0 0.005));
SETTINGS
  sed -i -E 's/^( *tolerance  *)1e-[0-9]+;/\11e-12;/; s/^( *relTol  *)0\.[0-9]+;/\10;/
    s/"U\.\*"/"(U|k|epsilon|omega|nuTilda).*"/' system/fvSolution
  sed -i 's/^writePrecision.*/writePrecision 17;/; /^functions/,$d' system/controlDict
  cat >>system/controlDict <<'DICT'
functions
{
    wallForce { type forces; libs (forces); patches (wall); rho rhoInf; rhoInf 1; CofR (0 0 0);
        writeControl timeStep; writeInterval 1; log no; }
    shear { type wallShearStress; libs (fieldFunctionObjects); patches (wall);
        writeControl timeStep; writeInterval 1; log no; }
    wallUnits { type yPlus; libs (fieldFunctionObjects);
        writeControl timeStep; writeInterval 1; log no; }
}
DICT
  sed -i 's/default         none;/default         Gauss upwind;/' system/fvSchemes
  echo 'wallDist { method meshWave; }' >>system/fvSchemes
  dictionary constant/turbulenceProperties "simulationType $2;
$2 { $2Model $3; turbulence on; printCoeffs off; delta cubeRootVol; cubeRootVolCoeffs {} }"
  local name dims value wall
  while read -r name value wall dims; do
    scalar_field "$name" "$dims" "uniform $value" "inlet { type fixedValue; value uniform $value; }
      outlet { type zeroGradient; } wall { type $wall; value uniform $value; }"
  done <<FIELDS
k 0.4 kqRWallFunction $dim_k
epsilon 500 epsilonWallFunction $dim_epsilon
omega 14000 omegaWallFunction $dim_omega
nuTilda 1e-4 fixedValue $dim_nut
FIELDS
  scalar_field nut "$dim_nut" 'uniform 0' '"inlet|outlet" { type calculated; value uniform 0; }
    wall { type nutkWallFunction; value uniform 0; }'
  if [[ $3 == Spalart* || $2 == LES ]]; then sed -i 's/nutkWall/nutUSpaldingWall/' 0/nut; fi
  if [[ $2 == LES ]]; then sed -i 's/kqRWallFunction/zeroGradient/' 0/k; fi
  if [[ -d $work/mesh ]]; then
    cp -r "$work/mesh" constant/polyMesh
  else
    blockMesh >log.blockMesh 2>&1
    cp -r constant/polyMesh "$work/mesh"
  fi
}
fluid_fraction() { scalar_field alphaf '[0 0 0 0 0 0 0]' "uniform $1" '".*" { type zeroGradient; }'; }

# A periodic column of N cells of 1/N m, fluid at rest.
new_column() { # NAME N DT END
  case_dir=$work/$1
  mkdir -p "$case_dir"
  cd "$case_dir"
  cp -r "$root"/foam_cases/closed_box/{0,constant,system} .
  rm constant/couplingProperties
  echo "side 1; cells ($2 1 1); endTime $4; deltaT $3;" >system/caseSettings
  sed -i 's/^writePrecision.*/writePrecision 17;/; /^functions/,$d' system/controlDict
  sed -i 's/default         none/default Gauss linear/' system/fvSchemes
  sed -i 's/"U\.\*"/"(U|k|epsilon).*"/' system/fvSolution
  sed -i 's/uniform (5 0 0)/uniform (0 0 0)/' 0/U
  scalar_field nut "$dim_nut" 'uniform 0' '".*" { type cyclic; }'
  blockMesh >log.blockMesh 2>&1
}
wave() { # N MEAN AMPLITUDE PHASE: values of a list
  awk -v n="$1" -v a="$2" -v b="$3" -v p="$4" 'BEGIN { printf "nonuniform List<scalar> %d (", n
    for (i = 0; i < n; i++) printf "%.17g ", a + b*sin(2*3.14159265358979*(i + 0.5)/n + p); print ")" }'
}

# Values of a field, or of a table, one per line; with `internal` those of cells only. Left out are lengths
# of lists and the constants of wall functions.
numbers() { # FILE [internal]
  awk -v internal="${2:-}" '
    /^FoamFile/ { header = 1 }
    header { if (/}/) header = 0; next }
    internal && /^boundaryField/ { exit }
    /dimensions|^ *\/\/|^ *[A-Za-z0-9]+ +[-+0-9.e]+;$/ { next }
    sub(/.*List<[a-z]+> */, "") && !sub(/^[0-9]+/, "") { getline; next }
    { gsub(/[();]/, " "); for (i = 1; i <= NF; i++) if ($i ~ /^-?[0-9.]+(e[-+]?[0-9]+)?$/) print $i }' "$1"
}
same() { # WHAT FILE FILE TOLERANCE: largest difference over the largest number
  local d
  d=$(paste <(numbers "$2") <(numbers "$3") | awk '{ if (NF != 2) bad = 1; e = $1 - $2; if (e < 0) e = -e
    s = $2 < 0 ? -$2 : $2; if (e > w) w = e; if (s > m) m = s } END { print (bad || !(m > 0)) ? "nothing" : w/m }')
  echo "$1: $d"
  awk -v d="$d" -v t="$4" 'BEGIN { exit !(d != "nothing" && d + 0 <= t) }' || failed "$1: differ by $d, above $4"
}
within() { # WHAT VALUE EXPECTED TOLERANCE (relative)
  echo "$1: $2, expected $3"
  awk -v v="$2" -v r="$3" -v t="$4" 'BEGIN { e = v/r - 1; exit !(v != "" && e <= t && -e <= t) }' ||
    failed "$1: $2, expected $3 within $4"
}
# Column sums of the last line of a function object's table.
last() { awk '!/^#/ { gsub(/[()]/, " "); row = $0 } END { print row }' "$1"; }

# Solvers stop at 1e-12 of their residual; ten steps and the ratio of a matrix's eigenvalues come on top.
solver_tolerance=1e-8

case $test in
  stock)
    # Without particles each model gives what it gives in pisoFoam, and function objects find it.
    for entry in "RAS kEpsilon" "RAS kOmegaSST" "RAS realizableKE" "RAS SpalartAllmaras" "LES Smagorinsky" "LES kEqn"; do
      read -r type model <<<"$entry"
      new_pipe "$model.piso" "$type" "$model"
      sed -i 's/^PIMPLE/PISO/' system/fvSolution
      solver=pisoFoam; solve
      new_pipe "$model" "$type" "$model"
      solver=powderFoam; solve
      for field in U p phi nut k epsilon omega nuTilda wallShearStress yPlus; do
        [[ ! -f ../$model.piso/0.0002/$field ]] ||
          same "$model, $field" "0.0002/$field" "../$model.piso/0.0002/$field" $solver_tolerance
      done
      same "$model, force on the wall" <(last postProcessing/wallForce/0/force.dat) \
        <(last "../$model.piso/postProcessing/wallForce/0/force.dat") $solver_tolerance
    done
    ;;
  uniform)
    # A uniform alphaf cancels, but for the stress: the fluid touches alphaf of the wall.
    for model in kEpsilon kOmegaSST; do
      new_pipe "$model.1" RAS $model; solve
      new_pipe "$model.alphaf" RAS $model; fluid_fraction 0.6; solve
      for field in U p k epsilon omega nut; do
        [[ ! -f ../$model.1/0.0002/$field ]] ||
          same "$model, $field" "0.0002/$field" "../$model.1/0.0002/$field" $solver_tolerance
      done
      # Columns: time, total (3), pressure (3), viscous (3)
      within "$model, viscous force along the pipe" "$(last postProcessing/wallForce/0/force.dat | awk '{ print $10 }')" \
        "$(last "../$model.1/postProcessing/wallForce/0/force.dat" | awk '{ printf "%.12g", 0.6*$10 }')" 1e-6
    done
    ;;
  diffusion)
    # Without production and dissipation the column keeps sum(alphaf k) while k spreads; sum(k) it does
    # not keep. nut = Cmu k^2/epsilon = 0.01 m2/s, dissipated 1e-12 of k per second.
    spread() { # NAME
      new_column "$1" 16 0.05 4
      dictionary constant/turbulenceProperties 'simulationType RAS;
RAS { RASModel kEpsilon; turbulence on; printCoeffs off; kEpsilonCoeffs { Cmu 1e-14; } }'
      scalar_field alphaf '[0 0 0 0 0 0 0]' "$(wave 16 0.6 0.3 0)" '".*" { type cyclic; }'
      scalar_field k "$dim_k" "$(wave 16 1 0.5 0.8)" '".*" { type cyclic; }'
      scalar_field epsilon "$dim_epsilon" 'uniform 1e-12' '".*" { type cyclic; }'
    }
    sums() { paste <(numbers 0/alphaf internal) <(numbers "$1/k" internal) |
      awk '{ a += $1*$2; b += $2 } END { printf "%.12g %.12g\n", a, b }'; }
    spread closed
    solve
    read -r held plain < <(sums 0)
    read -r held_end plain_end < <(sums 4)
    within "sum of alphaf k" "$held_end" "$held" 1e-9
    echo "sum of k: $plain, then $plain_end"
    awk -v a="$plain" -v b="$plain_end" 'BEGIN { exit !(b/a < 0.95 || b/a > 1.05) }' || failed "k did not spread"
    # fvOptions act per volume of cell: 0.1 m2/s3 in each of 16 cells for 4 s.
    spread source
    dictionary system/fvOptions 'sourceOfK { type scalarSemiImplicitSource; selectionMode all;
volumeMode specific; injectionRateSuSp { k (0.1 0); } }'
    solve
    read -r held_end _ < <(sums 4)
    within "sum of alphaf k with a source" "$held_end" "$(awk -v a="$held" 'BEGIN { printf "%.12g", a + 16*0.1*4 }')" 1e-9
    ;;
  decay)
    # Homogeneous turbulence of kEpsilon in any alphaf(x): k = k0 (1 + (C2 - 1) eps0 t/k0)^(-1/(C2 - 1)).
    errors=()
    for steps in 100 200; do
      new_column "column_$steps" 8 "$(awk -v n=$steps 'BEGIN { print 1/n }')" 1
      dictionary constant/turbulenceProperties 'simulationType RAS;
RAS { RASModel kEpsilon; turbulence on; printCoeffs off; kEpsilonCoeffs { C2 1.92; } }'
      scalar_field alphaf '[0 0 0 0 0 0 0]' "$(wave 8 0.6 0.3 0)" '".*" { type cyclic; }'
      scalar_field k "$dim_k" 'uniform 1' '".*" { type cyclic; }'
      scalar_field epsilon "$dim_epsilon" 'uniform 2' '".*" { type cyclic; }'
      solve
      read -r low high < <(numbers 1/k internal | awk '{ if (!n++ || $1 < a) a = $1; if ($1 > b) b = $1 } END { printf "%.17g %.17g\n", a, b }')
      # Uniform stays uniform, whatever alphaf does.
      within "$steps steps, largest k over the smallest" "$(awk -v a="$high" -v b="$low" 'BEGIN { printf "%.12g", a/b }')" 1 1e-8
      errors+=("$(awk -v k="$low" 'BEGIN { print k/(1 + 0.92*2)^(-1/0.92) - 1 }')")
    done
    echo "decay: relative errors ${errors[*]}"
    # The time scheme is of first order: the error halves, and twice the fine minus the coarse result has
    # one of second order only.
    awk -v a="${errors[0]}" -v b="${errors[1]}" 'BEGIN { exit !(a/b > 1.9 && a/b < 2.1 && (2*b - a)^2 < 0.002^2) }' ||
      failed "decay: errors ${errors[*]}"
    ;;
  walls)
    # As gmshToFoam writes a mesh: every patch is a `patch`. Nothing else differs from run to run.
    warning='needs the distance to the wall'
    walls_of() { # NAME MODEL WARNS
      new_pipe "$1" RAS "$2"
      sed -i -E 's/^( *)type +wall;/\1type patch;/; /inGroups/d' constant/polyMesh/boundary
      sed -i 's/wall { type [a-zA-Z]*WallFunction;/wall { type calculated;/' 0/nut
      sed -i 's/\(wall { type \)[a-zA-Z]*WallFunction;/\1fixedValue;/' 0/k 0/epsilon 0/omega
      sed -i '/^functions/,$d' system/controlDict
      solve
      if [[ $3 == yes ]]; then
        [[ $(grep -c "$warning" log) == 1 ]] || failed "$1: $(grep -c "$warning" log) warnings"
      else
        ! grep -q "$warning" log || failed "$1: warns of walls"
      fi
    }
    walls_of sst kOmegaSST yes
    grep -q 'no patch with faces is of type wall' log || failed "kOmegaSST without walls"
    walls_of spalart SpalartAllmaras yes
    walls_of kepsilon kEpsilon no       # has no wall distance
    new_pipe marked RAS kOmegaSST
    solve
    ! grep -q "$warning" log || failed "warns although the wall is one"
    # A wall that is marked does not speak for one that is not: the inlet closed, as a patch.
    new_pipe closed RAS kOmegaSST
    sed -i -E '/^ *inlet/,/\}/ s/type +[^;]*;/type noSlip;/' 0/U
    sed -i -E '/^ *inlet/,/\}/ s/type +[^;]*;/type zeroGradient;/' 0/p
    sed -i '/^functions/,$d' system/controlDict
    solve
    grep -qF "the patches 1(inlet) with the condition noSlip are not of type wall" log || failed "a closed inlet"
    ;;
  refusals)
    new_pipe bad RAS kEpsilon
    sed -i 's/simulationType RAS/simulationType RSA/' constant/turbulenceProperties
    code=0
    "$bin/powderFoam" >log 2>&1 || code=$?
    [[ $code != 0 ]] || failed "misspelt simulationType: accepted"
    for text in given: allowed: "to do:" RSA "laminar RAS LES"; do
      grep -qF -- "$text" log || failed "misspelt simulationType: the message lacks '$text'"
    done
    # A model with a stress that the momentum equation does not have.
    new_pipe stress RAS LRR
    code=0
    "$bin/powderFoam" >log 2>&1 || code=$?
    [[ $code != 0 ]] || failed "LRR: accepted"
    grep -q kOmegaSST log || failed "LRR: no list of the models"
    ;;
  *)
    echo "unknown test: $test" >&2
    exit 2
    ;;
esac
exit $status
