#!/usr/bin/env bash
# The x, y, z co-ords in the head of forceBin.dat (function object forces with binData) are where the bins
# end, not their middles; and the bins reach from the first to the last face's centre, not over the patch.
# A floor from x = 1 to 3 of 40 faces under a pressure of 1 in four bins, each of ten faces: the load of
# each is 0.5 and its middle 1.25, 1.75, 2.25, 2.75; printed are 1.51, 2.00, 2.49, 2.98, and a start of
# 1.025. A load drawn over them is shifted by half a bin, 0.24 here.
# Debian's openfoam 1912.200626. Fails if that changes.
set -euo pipefail
version=$(dpkg-query -W -f '${Version}' libopenfoam)
[[ $version == 1912* ]] || { echo "seen with 1912.200626, here is $version" >&2; exit 1; }
export WM_PROJECT_DIR=/usr/share/openfoam
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"
mkdir 0 constant system
file() { echo "FoamFile { version 2.0; format ascii; class $1; object $2; }"; }
{ file dictionary blockMeshDict
  echo 'vertices ((1 0 0) (3 0 0) (3 1 0) (1 1 0) (1 0 1) (3 0 1) (3 1 1) (1 1 1));
    blocks (hex (0 1 2 3 4 5 6 7) (40 1 1) simpleGrading (1 1 1));
    defaultPatch { name sides; type patch; } boundary (floor { type wall; faces ((0 3 2 1)); });'
} >system/blockMeshDict
{ file dictionary controlDict
  echo 'startFrom startTime; startTime 0; stopAt endTime; endTime 1; deltaT 1; writeControl none; writeInterval 1;
    functions { load { type forces; libs (forces); patches (floor); rho rhoInf; rhoInf 1; CofR (0 0 0);
      writeControl timeStep; writeInterval 1; binData { nBin 4; direction (1 0 0); cumulative no; } } }'
} >system/controlDict
{ file dictionary fvSchemes
  echo 'ddtSchemes { default steadyState; } gradSchemes { default Gauss linear; }
    divSchemes { default Gauss linear; } laplacianSchemes { default Gauss linear corrected; }
    snGradSchemes { default corrected; } interpolationSchemes { default linear; }'; } >system/fvSchemes
{ file dictionary fvSolution; echo 'SIMPLE { pRefCell 0; pRefValue 0; }'; } >system/fvSolution
{ file dictionary transportProperties; echo 'transportModel Newtonian; nu 1;'; } >constant/transportProperties
{ file dictionary turbulenceProperties; echo 'simulationType laminar;'; } >constant/turbulenceProperties
{ file volVectorField U
  echo 'dimensions [0 1 -1 0 0 0 0]; internalField uniform (0 0 0); boundaryField { ".*" { type zeroGradient; } }'
} >0/U
{ file volScalarField p
  echo 'dimensions [0 2 -2 0 0 0 0]; internalField uniform 1; boundaryField { ".*" { type zeroGradient; } }'
} >0/p
for program in blockMesh 'simpleFoam -postProcess'; do
  timeout 60 $program >log 2>&1 || { tail -20 log >&2; exit 1; }
done
awk '
  /^# (start|x co-ords)/ { print }
  /^# start/ { start = $4 }
  /^# x co-ords/ { for (i = 1; i <= 4; i++) end[i] = $(i + 4) }
  !/^#/ { gsub(/[()]/, ""); for (i = 0; i < 4; i++) load[i] = $(4 + 9*i) }
  END {
    print "loads:", load[0], load[1], load[2], load[3]
    for (i = 0; i < 4; i++) if (load[i] != -0.5) exit 1
    if ((start - 1.025)^2 > 1e-8) exit 1
    for (i = 1; i <= 4; i++) if ((end[i] - start - i*1.95/4)^2 > 1e-6) exit 1
  }' postProcessing/load/0/forceBin.dat
