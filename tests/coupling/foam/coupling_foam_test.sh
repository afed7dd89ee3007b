#!/usr/bin/env bash
# coupling_foam_test.sh box|cube|pipe|twisted RANKS PROGRAM REPOSITORY WORK
# Makes the mesh, then runs the tests on one rank and, if asked, decomposed on RANKS.
set -euo pipefail
name=$1 ranks=$2 program=$3 root=$4 work=$5/$1_$2
export WM_PROJECT_DIR=${WM_PROJECT_DIR:-/usr/share/openfoam}
export OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1
run_limit_s=150
options=()

rm -rf "$work"
mkdir -p "$work/$name/system" "$work/$name/constant"
cd "$work/$name"
dictionary() { # FILE ENTRIES
  printf 'FoamFile { version 2.0; format ascii; class dictionary; object %s; }\n%s\n' \
    "$(basename "$1")" "$2" >"$1"
}
dictionary system/controlDict 'application coupling_foam_test; startFrom startTime; startTime 0;
stopAt endTime; endTime 1; deltaT 1; writeControl timeStep; writeInterval 1;'
dictionary system/fvSchemes 'ddtSchemes { default Euler; } gradSchemes { default Gauss linear; }
divSchemes { default Gauss linear; } laplacianSchemes { default Gauss linear corrected; }
interpolationSchemes { default linear; } snGradSchemes { default corrected; }'
dictionary system/fvSolution ''
case $name in
  cube)
    # 24 x 24 x 24 cells of 1 mm, periodic in z
    dictionary system/blockMeshDict 'scale 0.024;
vertices ((0 0 0) (1 0 0) (1 1 0) (0 1 0) (0 0 1) (1 0 1) (1 1 1) (0 1 1));
blocks (hex (0 1 2 3 4 5 6 7) (24 24 24) simpleGrading (1 1 1));
boundary (walls { type wall; faces ((0 1 5 4) (1 2 6 5) (2 3 7 6) (3 0 4 7)); }
bottom { type cyclic; neighbourPatch top; faces ((0 3 2 1)); }
top { type cyclic; neighbourPatch bottom; faces ((4 5 6 7)); });'
    # 2 ranks have the periodic patches whole, with 3 they are between ranks.
    split='(2 1 1)'
    if [[ $ranks -eq 3 ]]; then split='(1 1 3)'; fi
    ;;
  box)
    # 6 x 8 x 10 cells of 1 mm, periodic in all directions; what else is tested needs walls.
    dictionary system/blockMeshDict 'scale 0.001;
vertices ((0 0 0) (6 0 0) (6 8 0) (0 8 0) (0 0 10) (6 0 10) (6 8 10) (0 8 10));
blocks (hex (0 1 2 3 4 5 6 7) (6 8 10) simpleGrading (1 1 1));
boundary (left { type cyclic; neighbourPatch right; faces ((0 4 7 3)); }
right { type cyclic; neighbourPatch left; faces ((1 2 6 5)); }
front { type cyclic; neighbourPatch back; faces ((0 1 5 4)); }
back { type cyclic; neighbourPatch front; faces ((3 7 6 2)); }
bottom { type cyclic; neighbourPatch top; faces ((0 3 2 1)); }
top { type cyclic; neighbourPatch bottom; faces ((4 5 6 7)); });'
    split='(2 1 1)'
    if [[ $ranks -eq 4 ]]; then split='(1 2 2)'; fi
    options+=(--gtest_filter='PointValues.*:*.HasNoSeamAtPeriodicPatches:*Ties.*')
    ;;
  twisted)
    # The side faces of all cells are bent.
    dictionary system/blockMeshDict 'scale 0.01;
vertices ((-1 -1 0) (1 -1 0) (1 1 0) (-1 1 0) (-0.3 -1.4 2) (1.4 -0.3 2) (0.3 1.4 2) (-1.4 0.3 2));
blocks (hex (0 1 2 3 4 5 6 7) (8 8 8) simpleGrading (1 1 1));
boundary (walls { type wall; faces ((0 1 5 4) (1 2 6 5) (2 3 7 6) (3 0 4 7) (0 3 2 1) (4 5 6 7)); });'
    split='(1 1 2)'
    options+=(--gtest_filter='CellLocatorBentFaces.*:CellLocator.CentresAreInTheirCells:ParticleOwnership.PointsOnShared*')
    ;;
  pipe)
    cp "$root"/foam_cases/hagen_poiseuille/system/blockMeshDict system/
    # 40 layers of 2 mm; the cuts go through the O-grid, where faces of ranks are bent.
    dictionary system/caseSettings 'pipeLength 0.08; layers 40;'
    split='(2 1 1)'
    if [[ $ranks -eq 3 ]]; then split='(1 1 3)'; fi
    ;;
esac
blockMesh >log.blockMesh 2>&1 || { tail -n 20 log.blockMesh >&2; exit 1; }
timeout "$run_limit_s" "$program" "${options[@]}" -case "$PWD"
if [[ $ranks -gt 1 ]]; then
  dictionary system/decomposeParDict \
    "numberOfSubdomains $ranks; method simple; coeffs { n $split; delta 0.001; }"
  decomposePar >log.decomposePar 2>&1 || { tail -n 20 log.decomposePar >&2; exit 1; }
  timeout "$run_limit_s" mpirun -np "$ranks" --oversubscribe --bind-to none \
    --mca mpi_yield_when_idle 1 "$program" "${options[@]}" -case "$PWD" -parallel
fi
