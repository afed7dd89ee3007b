#!/usr/bin/env bash
# OpenFOAM v1912 (Debian 12, package openfoam 1912.200626): a dictionary whose last line is a `//` comment
# without a line end, as many editors leave it, is a fatal error, and the message names no character. A block comment
# that is never closed is taken without a word, with all that it hides.
# Seen:     `a 1;` and `// end` without a line end: FOAM FATAL IO ERROR, Invalid first character found, status 1;
#           `a 1;` and `/* end`, or `/* b 2;`: a is 1, status 0, no warning
# Expected: the comment ends with the file; the open one is named.
# Fails when that changes.
set -euo pipefail
export WM_PROJECT_DIR=${WM_PROJECT_DIR:-/usr/share/openfoam}
version=$(dpkg-query -W -f '${Version}' openfoam)
[[ $version == 1912.* ]] || { echo "findings: openfoam $version, not 1912"; exit 1; }
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"
header='FoamFile { version 2.0; format ascii; class dictionary; object x; }'
printf '%s\na 1;\n// end\n' "$header" >ended
printf '%s\na 1;\n// end' "$header" >cut
printf '%s\na 1;\n/* b 2;\n' "$header" >open
read_a() { foamDictionary -entry a -value "$1" >out 2>&1 && echo "status 0, a = $(tail -n 1 out)" || echo "status $?, $(grep -m 1 Invalid out)"; }
ended=$(read_a ended) cut=$(read_a cut) open=$(read_a open)
echo "openfoam $version: with a line end: $ended; without: $cut; open block comment: $open"
[[ $ended == "status 0, a = 1" && $cut == "status 1, Invalid first character found"* ]]
[[ $open == "status 0, a = 1" ]]
