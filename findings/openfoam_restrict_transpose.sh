#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# T(a temporary tensor field) of OpenFOAM v1912 (Debian 12, source headers 1912.200626), in a program of one's own that
# g++ 12.2 compiles with -O2 for a processor with AVX2 (-march=znver3, x86-64-v3, or native there).
# Expected: the transpose, as T(a field with a name) gives:  1 4 7  2 5 8  3 6 9.
# Seen:     1 4 7  2 5 8  7 6 9: the component zx stays as it was, without a word of compiler or program. So does it in
#           nuEff*dev2(T(fvc::grad(U))) of a solver: the x component of U is wrong.
# Not a fault of g++: T() of a temporary writes its result into the temporary itself, through one pointer, while it reads
# through another, and both are declared __restrict__ (ListLoopM.H): no overlap. g++ may then write before it has read,
# and does so where it packs both rows. Without that word (-D__restrict__=) the result is right with all optimisation;
# -fno-tree-slp-vectorize hides it.
# Usage: openfoam_restrict_transpose.sh [OpenFOAM include tree of scripts/openfoam_headers.sh]
# Fails (status 1) if that changes; status 2: cannot be seen on this machine.
set -euo pipefail
export WM_PROJECT_DIR=/usr/share/openfoam
compiler=$(g++ -dumpfullversion)
[[ $compiler == 12.2.* ]] || { echo "findings: g++ $compiler, not 12.2"; exit 1; }
version=$(dpkg-query -W -f '${Version}' openfoam)
[[ $version == 1912.* ]] || { echo "findings: openfoam $version, not 1912"; exit 1; }
for feature in avx2 bmi2 fma; do
  grep -qw "$feature" /proc/cpuinfo || { echo "findings: skipped, this processor has no $feature"; exit 2; }
done
root=$(cd "$(dirname "$0")/.." && pwd)
tree=${1:-$root/build/openfoam}
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
if [[ $# == 0 && ! -f $tree/.stamp && -x $root/scripts/openfoam_headers.sh ]]; then
  tree=$work/openfoam
  "$root/scripts/openfoam_headers.sh" "$tree"
fi
[[ -f $tree/src/OpenFOAM/lnInclude/tensorField.H ]] ||
  { echo "findings: skipped, no OpenFOAM headers in $tree; give the folder that scripts/openfoam_headers.sh makes"; exit 2; }
tree=$(cd "$tree" && pwd)
cd "$work"
mkdir system
head='FoamFile { version 2.0; format ascii; class dictionary; object x; }'
echo "$head application x; startFrom startTime; startTime 0; stopAt endTime; endTime 1; deltaT 1; writeInterval 1;" \
  >system/controlDict
echo "$head gradSchemes {} divSchemes {} laplacianSchemes {} interpolationSchemes {} snGradSchemes {} ddtSchemes {}" \
  >system/fvSchemes
echo "$head" >system/fvSolution
cat >system/blockMeshDict <<MESH
$head
vertices ((0 0 0) (1 0 0) (1 1 0) (0 1 0) (0 0 1) (1 0 1) (1 1 1) (0 1 1));
blocks (hex (0 1 2 3 4 5 6 7) (2 2 2) simpleGrading (1 1 1));
boundary ();
MESH
blockMesh >log.blockMesh
cat >transpose.C <<'CPP'
#include "argList.H"
#include "Time.H"
#include "fvMesh.H"
#include "volFields.H"
#include <cstdio>
using namespace Foam;

static void print(const char* what, const tensor& t)
{
    std::printf("%s", what);
    for (direction i = 0; i < tensor::nComponents; ++i) std::printf(" %g", t[i]);
    std::printf("\n");
}

int main(int argc, char* argv[])
{
    argList::noBanner();
    argList args(argc, argv);
    Time runTime(Time::controlDictName, args);
    fvMesh mesh(IOobject(fvMesh::defaultRegion, runTime.timeName(), runTime, IOobject::MUST_READ));
    const volTensorField g
    (
        IOobject("g", runTime.timeName(), mesh),
        mesh,
        dimensionedTensor("g", dimless, tensor(1, 2, 3, 4, 5, 6, 7, 8, 9))
    );
    const tmp<volTensorField> named(T(g)), temporary(T(1.0*g));
    print("named", named()[0]);
    print("temporary", temporary()[0]);
    return 0;
}
CPP
includes=()
for library in OpenFOAM OSspecific/POSIX finiteVolume meshTools surfMesh fileFormats; do
  includes+=(-isystem "$tree/src/$library/lnInclude")
done
transposed() {  # compiler flags: prints the two results
  g++ -std=c++17 -O2 -Wall -Wextra "$@" -DWM_DP -DWM_LABEL_SIZE=32 -DOPENFOAM=1912 -DNoRepository "${includes[@]}" \
    transpose.C -o transpose -Wl,--no-as-needed -lfiniteVolume -lmeshTools -lOpenFOAM -lPstream >messages 2>&1 ||
    { cat messages >&2; return 1; }
  [[ ! -s messages ]] || { echo "with warnings"; cat messages >&2; }
  ./transpose | grep -E '^(named|temporary) ' | paste -s -d ' '
}
declare -A results=(
  [right]="named 1 4 7 2 5 8 3 6 9 temporary 1 4 7 2 5 8 3 6 9"
  [wrong]="named 1 4 7 2 5 8 3 6 9 temporary 1 4 7 2 5 8 7 6 9"
)
echo "g++ $compiler, openfoam $version; the transpose of 1 2 3 4 5 6 7 8 9:"
status=0
while read -r expected flags; do
  read -ra words <<<"$flags"
  seen=$(transposed "${words[@]}")
  echo "-O2 $flags: $seen"
  [[ $seen == "${results[$expected]}" ]] || status=1
done <<'FLAGS'
wrong -march=znver3
wrong -march=x86-64-v3
right -march=znver3 -D__restrict__=
right -march=znver3 -fno-tree-slp-vectorize
right -march=x86-64
FLAGS
exit "$status"
