#!/usr/bin/env bash
# OpenFOAM v1912 (Debian 12, package openfoam 1912.200626-1+b1): the function object scalarTransport solves after
# the time folder has been written, so that the field in a folder is one time step older than U and p there,
# and a restart begins one step back. Seen: with dT/dt = 1 and steps of 0.1 s the folder 0.5 holds T = 0.4
# and the folder 1 holds 0.9, while volFieldValue gives 0.5 and 1.0. No message.
# Runs pisoFoam alone in a temporary folder; fails when that changes.
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
export WM_PROJECT_DIR=${WM_PROJECT_DIR:-/usr/share/openfoam}
dpkg-query -W -f 'version: ${Package} ${Version}\n' openfoam
mkdir 0 constant system
header() { echo "FoamFile { version 2.0; format ascii; class $1; object $2; }"; }
{
  header dictionary blockMeshDict
  echo 'scale 1; vertices ((0 0 0)(1 0 0)(1 1 0)(0 1 0)(0 0 1)(1 0 1)(1 1 1)(0 1 1));'
  echo 'blocks (hex (0 1 2 3 4 5 6 7) (2 2 2) simpleGrading (1 1 1)); edges (); boundary ();'
} >system/blockMeshDict
{
  header dictionary controlDict
  echo 'application pisoFoam; startFrom startTime; startTime 0; stopAt endTime; endTime 1; deltaT 0.1;'
  echo 'writeControl timeStep; writeInterval 5; writeFormat ascii; writePrecision 8; timePrecision 6;'
  echo 'functions { tracer { type scalarTransport; libs (solverFunctionObjects); field T; D 0;'
  echo '  fvOptions { grow { type scalarSemiImplicitSource; active yes; selectionMode all;'
  echo '    volumeMode specific; injectionRateSuSp { T (1 0); } } } }'
  echo '  mean { type volFieldValue; libs (fieldFunctionObjects); regionType all; operation volAverage;'
  echo '    fields (T); writeFields no; } }'
} >system/controlDict
{
  header dictionary fvSchemes
  echo 'ddtSchemes { default Euler; } gradSchemes { default Gauss linear; }'
  echo 'divSchemes { default Gauss upwind; div((nuEff*dev2(T(grad(U))))) Gauss linear; }'
  echo 'laplacianSchemes { default Gauss linear corrected; } interpolationSchemes { default linear; }'
  echo 'snGradSchemes { default corrected; }'
} >system/fvSchemes
{
  header dictionary fvSolution
  echo 'solvers { "p.*" { solver PCG; preconditioner DIC; tolerance 1e-9; relTol 0; }'
  echo '  "(U|T).*" { solver PBiCGStab; preconditioner DILU; tolerance 1e-12; relTol 0; } }'
  echo 'PISO { nCorrectors 1; pRefCell 0; pRefValue 0; }'
} >system/fvSolution
{ header dictionary transportProperties; echo 'transportModel Newtonian; nu 1e-5;'; } >constant/transportProperties
{ header dictionary turbulenceProperties; echo 'simulationType laminar;'; } >constant/turbulenceProperties
field() {  # class name dimensions value condition
  header "$1" "$2"
  echo "dimensions $3; internalField uniform $4; boundaryField { \".*\" { type $5; } }"
}
field volVectorField U '[0 1 -1 0 0 0 0]' '(0 0 0)' noSlip >0/U
field volScalarField p '[0 2 -2 0 0 0 0]' 0 zeroGradient >0/p
field volScalarField T '[0 0 0 0 0 0 0]' 0 zeroGradient >0/T
blockMesh >log.blockMesh
pisoFoam >log.pisoFoam
for time in 0.5 1; do
  inside=$(awk '/^internalField/ { sub(";", ""); print $3 }' "$time/T")
  solved=$(awk -v t="$time" '$1 == t { print $2 + 0 }' postProcessing/mean/0/volFieldValue.dat)
  echo "time $time s: T in the folder $inside, T that was solved $solved"
  awk -v i="$inside" -v s="$solved" 'BEGIN { d = s - i - 0.1; exit !(d*d < 1e-12) }'
done
