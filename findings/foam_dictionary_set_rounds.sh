#!/usr/bin/env bash
# foamDictionary of OpenFOAM v1912 (Debian 12, package openfoam 1912.200626): `-set` one entry, and every other
# number of the file is rounded to six digits and its comments go, without a word and with status 0.
# Seen:     nu 1.3433734940e-05; becomes nu 1.34337e-05;   (relative 2.6e-6), status 0, no warning
# Expected: the other entries stay; `-precision 15` keeps them.
# Fails when that changes.
set -euo pipefail
export WM_PROJECT_DIR=${WM_PROJECT_DIR:-/usr/share/openfoam}
version=$(dpkg-query -W -f '${Version}' openfoam)
[[ $version == 1912.* ]] || { echo "findings: openfoam $version, not 1912"; exit 1; }
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"
printf 'FoamFile { version 2.0; format ascii; class dictionary; object transportProperties; }\n' >transportProperties
printf '// argon\nnu 1.3433734940e-05;\nrho 1.66;\n' >>transportProperties
cp transportProperties kept
foamDictionary -entry rho -set 1.7 transportProperties >/dev/null 2>messages
status=$?
seen=$(sed -n 's/^nu *//p' transportProperties)
foamDictionary -precision 15 -entry rho -set 1.7 kept >/dev/null 2>&1
kept=$(sed -n 's/^nu *//p' kept)
echo "openfoam $version: nu 1.3433734940e-05; after -entry rho -set 1.7: nu $seen (status $status, messages: $(wc -c <messages) bytes); with -precision 15: nu $kept"
[[ $status == 0 && ! -s messages && $seen == "1.34337e-05;" && $kept == "1.343373494e-05;" ]]
! grep -q argon transportProperties
