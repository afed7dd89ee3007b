#!/usr/bin/env bash
# bench/pipe/build_mppic.sh FOLDER: FOLDER/MPPICFoam, the program of Debian's OpenFOAM compiled again
# from its own source with -O2. The packaged one (-O3) diverges on the pipe's mesh in its first step,
# even without grains. It uses the packaged libraries. Some minutes; does nothing when it is there.
set -euo pipefail

fail() {  # what failed; what was given; what is allowed; what to do
  printf 'build_mppic.sh: %s; given: %s; allowed: %s; to do: %s\n' "$@" >&2
  exit 1
}
[[ $# -eq 1 ]] || fail "wrong arguments" "$*" "one folder" "bench/pipe/build_mppic.sh build/mppic"
version=$(dpkg-query -W -f '${source:Version}' libopenfoam 2>/dev/null) ||
  fail "the package libopenfoam is not installed" "this machine" "Debian with openfoam" "scripts/setup.sh"
mkdir -p "$1"
out=$(realpath "$1")
if [[ -x $out/MPPICFoam && $(cat "$out/.version" 2>/dev/null) == "$version" ]]; then exit 0; fi
work=$(mktemp -d "$out/work.XXXXXX")
trap 'rm -rf "$work"' EXIT
cd "$work"

# The machine's own apt sources as deb-src, in a private list.
mkdir -p sources lists/partial cache/archives/partial tree
for file in /etc/apt/sources.list /etc/apt/sources.list.d/*; do
  case $file in
    *.sources) sed -E 's/^[Tt]ypes:.*/Types: deb-src/' "$file" >"sources/${file##*/}" ;;
    *.list) [[ ! -f $file ]] || sed -nE 's/^[[:space:]]*deb([[:space:]])/deb-src\1/p' "$file" >"sources/${file##*/}" ;;
  esac
done
apt() {
  timeout 900 apt-get -q -y -o Dir::Etc::sourcelist=/dev/null -o Dir::Etc::sourceparts="$work/sources" \
    -o Dir::State::lists="$work/lists" -o Dir::Cache="$work/cache" -o APT::Sandbox::User=root "$@"
}
apt update >log 2>&1 || true
apt source --download-only --tar-only "openfoam=$version" >>log 2>&1 || {
  tail -n 5 log >&2
  fail "cannot fetch the OpenFOAM source" "openfoam=$version" "a mirror that has it" "check the network"
}
tar -xf openfoam_*.orig.tar.* -C tree --strip-components=1 --wildcards \
  '*/applications/solvers/lagrangian/DPMFoam/*' '*/src/*.[CHh]'

headers() {  # folder: what OpenFOAM calls lnInclude
  mkdir -p "$1/lnInclude"
  (cd "$1/lnInclude" && find .. -name lnInclude -prune -o -type f -name '*.[CHh]' -exec ln -sf -t . {} +)
}
program=$work/tree/applications/solvers/lagrangian/DPMFoam
includes=(-I "$program/MPPICFoam" -I "$program" -I "$program/DPMTurbulenceModels/lnInclude"
  -I tree/src/transportModels -I tree/src/transportModels/incompressible/singlePhaseTransportModel)
headers "$program/DPMTurbulenceModels"
for library in OpenFOAM OSspecific/POSIX finiteVolume meshTools fvOptions sampling surfMesh dynamicMesh \
  dynamicFvMesh \
  lagrangian/basic lagrangian/intermediate lagrangian/turbulence lagrangian/distributionModels \
  thermophysicalModels/specie thermophysicalModels/basic thermophysicalModels/reactionThermo \
  thermophysicalModels/radiation thermophysicalModels/thermophysicalProperties \
  thermophysicalModels/solidThermo thermophysicalModels/SLGThermo thermophysicalModels/solidSpecie \
  transportModels/compressible TurbulenceModels/turbulenceModels TurbulenceModels/incompressible \
  TurbulenceModels/phaseIncompressible regionModels/regionModel regionModels/surfaceFilmModels; do
  headers "tree/src/$library"
  includes+=(-I "tree/src/$library/lnInclude")
done
echo "MPPICFoam: compiling with -O2" >&2
libraries=$(dirname "$(dpkg -L libopenfoam | grep -m1 '/libfiniteVolume\.so')")
limit=(timeout 1800)
"${limit[@]}" g++ -std=c++11 -O2 -fPIC -DOPENFOAM=1912 -DWM_DP -DWM_LABEL_SIZE=32 -DNoRepository \
  -ftemplate-depth=100 -w "${includes[@]}" -o MPPICFoam "$program/MPPICFoam/MPPICFoam.C" \
  -L "$libraries" -Wl,-rpath,"$libraries" -Wl,--no-as-needed -lfiniteVolume -lfvOptions -lmeshTools \
  -llagrangian -llagrangianIntermediate -llagrangianTurbulence -lspecie -lradiationModels \
  -lincompressibleTransportModels -lturbulenceModels -lincompressibleTurbulenceModels \
  -lDPMTurbulenceModels -lregionModels -lsurfaceFilmModels -lsampling -lOpenFOAM -lPstream >log 2>&1 || {
  grep -m 5 error log >&2 || tail -n 5 log >&2
  fail "MPPICFoam does not compile" "openfoam $version" "g++ and the packaged libraries" "bench without it"
}
mv MPPICFoam "$out/MPPICFoam"
echo "$version" >"$out/.version"
