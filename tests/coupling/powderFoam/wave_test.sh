#!/usr/bin/env bash
# wave_test.sh ROOT BIN LIBRARY WORK: convergence of powderFoam with alphaf varying in space and time.
#
# Particles move with speed c through a periodic box without wall and viscosity:
#   alphaf = a + b sin(X),  X = 2 pi (x - c t)/L
# Exact solution, any F (one dimension; U - c is steady in the frame of the particles):
#   continuity          alphaf (U - c) = F
#   momentum, model A   p = - (U - c)^2/2 + const
#   momentum, model B   p = - F U + const
#   k of kEpsilon without viscosity and dissipation: D ln k/Dt = -2/3 div U, so k/alphaf^(2/3) = const
set -euo pipefail
root=$1 bin=$2 library=$3 work=$4/wave
export WM_PROJECT_DIR=${WM_PROJECT_DIR:-/usr/share/openfoam}
rm -rf "$work"
mkdir -p "$work"
status=0
failed() { echo "FAILED: $*" >&2; status=1; }

mean=0.7 amplitude=0.1 speed=1 flux=0.35
end_time=0.4

field() {  # name class dimensions formula(x), as in awk; cells from $cells
  awk -v n="$cells" -v a=$mean -v b=$amplitude -v c=$speed -v f=$flux -v name="$1" -v class="$2" -v dims="$3" '
    BEGIN {
      printf "FoamFile { version 2.0; format ascii; class %s; object %s; }\ndimensions %s;\n", class, name, dims
      printf "internalField nonuniform List<%s> %d (\n", class == "volVectorField" ? "vector" : "scalar", n
      for (i = 0; i < n; i++) {
        alphaf = a + b*sin(2*3.14159265358979*(i + 0.5)/n); U = c + f/alphaf
        if (name == "U") printf "(%.17g 0 0)\n", U
        if (name == "alphaf") printf "%.17g\n", alphaf
        if (name == "k") printf "%.17g\n", alphaf^(2/3)
        # So slow a decay and so small a viscosity that k does not feel them
        if (name == "epsilon") print 1e-12
        if (name == "nut") print 0
      }
      print "); boundaryField { \".*\" { type cyclic; } }" }' >"0/$1"
}

# run NAME CELLS STEPS MODEL DDT OUTER: leaves the rms errors in error_U, error_p, error_k
run() {
  local name=$1 model=$4 ddt=$5 outer=$6
  cells=$2
  mkdir -p "$work/$name"
  cd "$work/$name"
  cp -r "$root"/foam_cases/closed_box/{0,constant,system} .
  local dt
  dt=$(awk -v t=$end_time -v n="$3" 'BEGIN { printf "%.17g", t/n }')
  echo "side 1; cells ($cells 1 1); endTime $end_time; deltaT $dt;" >system/caseSettings
  sed -i "s/^writePrecision.*/writePrecision 17;/; /^functions/,\$d" system/controlDict
  echo "libs (\"$library\");" >>system/controlDict
  sed -i "s/default         Euler/default         $ddt/; s/default         none/default Gauss linear/
    s/linearUpwind grad(U)/linear/" system/fvSchemes
  sed -i "s/nOuterCorrectors .*/nOuterCorrectors $outer;/; s/\"U\.\*\"/\"(U|k|epsilon).*\"/" system/fvSolution
  sed -i 's/^nu .*/nu 1e-15;/' constant/transportProperties
  echo "FoamFile { version 2.0; format ascii; class dictionary; object turbulenceProperties; }
simulationType RAS;
RAS { RASModel kEpsilon; turbulence on; printCoeffs off; kEpsilonCoeffs { Cmu 1e-30; } }" \
    >constant/turbulenceProperties
  echo "FoamFile { version 2.0; format ascii; class dictionary; object couplingProperties; }
model $model;
particleMomentum { type wave; mean $mean; amplitude $amplitude; speed $speed; length 1; }" \
    >constant/couplingProperties
  field U volVectorField '[0 1 -1 0 0 0 0]'
  field alphaf volScalarField '[0 0 0 0 0 0 0]'
  field k volScalarField '[0 2 -2 0 0 0 0]'
  field epsilon volScalarField '[0 2 -3 0 0 0 0]'
  field nut volScalarField '[0 2 -1 0 0 0 0]'
  blockMesh >log.blockMesh 2>&1
  "$bin/powderFoam" >log 2>&1 || { tail -n 20 log >&2; failed "$name: exit status $?"; }
  read -r error_U error_p error_k < <(for f in U p k; do
    awk -v f=$f '/^\)/ { exit } on { gsub(/[()]/, " "); print f, $1 } /^\($/ { on = 1 }' $end_time/$f
  done | awk -v n="$cells" -v a=$mean -v b=$amplitude -v c=$speed -v f=$flux -v t=$end_time -v model="$model" '
    { v[$1, m[$1]++] = $2 }
    END {
      if (m["U"] != n || m["p"] != n || m["k"] != n) { print "nan nan nan"; exit }
      for (i = 0; i < n; i++) {
        alphaf = a + b*sin(2*3.14159265358979*((i + 0.5)/n - c*t)); U = c + f/alphaf
        p[i] = v["p", i] - (model == "A" ? -(U - c)^2/2 : -f*U); shift += p[i]/n
        eU += (v["U", i] - U)^2/n; ek += (v["k", i] - alphaf^(2/3))^2/n
      }
      for (i = 0; i < n; i++) ep += (p[i] - shift)^2/n
      print sqrt(eU), sqrt(ep), sqrt(ek) }')
  echo "$name: rms errors of U $error_U, p $error_p, k $error_k"
}
order() {  # what coarse fine ratio-of-steps expected
  awk -v a="$2" -v b="$3" -v r="$4" -v e="$5" -v w="$6" -v what="$1" 'BEGIN {
    o = b > 0 ? log(a/b)/log(r) : 0; printf "%s: order %.2f, expected %s\n", what, o, e
    exit !(a + 0 > 0 && o > e - w && o < e + w) }' || failed "$1: not of order $5"
}
# What the next order leaves in the observed one at these steps.
width=0.3

for model in A B; do
  # In space: the time step falls with the square of the cell, so that its first-order error does too.
  run "space_${model}_coarse" 16 160 $model Euler 1
  coarse=("$error_U" "$error_p" "$error_k")
  run "space_${model}_fine" 32 640 $model Euler 1
  order "model $model, cells, U" "${coarse[0]}" "$error_U" 2 2 $width
  order "model $model, cells, p" "${coarse[1]}" "$error_p" 2 2 $width
  order "model $model, cells, k" "${coarse[2]}" "$error_k" 2 2 $width
  # Continuity is kept to the tolerance of the pressure's solver.
  awk '/^time step cont/ { if ($9 + 0 > w) w = $9 + 0; n++ } END { exit !(n && w < 1e-12) }' log ||
    failed "model $model: continuity"
done

# In time, with cells so small that their error is a tenth.
run time_coarse 64 20 A Euler 1
coarse=("$error_U" "$error_p" "$error_k")
run time_fine 64 40 A Euler 1
order "time step, U" "${coarse[0]}" "$error_U" 2 1 $width
order "time step, p" "${coarse[1]}" "$error_p" 2 1 $width
order "time step, k" "${coarse[2]}" "$error_k" 2 1 $width

# PIMPLE with outer correctors takes the flux of the new time: with `backward` second order in both.
run pimple_coarse 32 20 A backward 3
coarse=("$error_U" "$error_p")
run pimple_fine 64 40 A backward 3
order "PIMPLE, U" "${coarse[0]}" "$error_U" 2 2 $width
order "PIMPLE, p" "${coarse[1]}" "$error_p" 2 2 $width
exit $status
