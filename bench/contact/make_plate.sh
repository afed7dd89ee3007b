#!/usr/bin/env bash
# make_plate.sh FILE: square plate z = 0 of 2 x 20 x 20 triangles inside the benchmark's box.
set -euo pipefail
awk 'function v(i) { return 2e-7 + 0.0059996 * i / 20 }
function tri(a,b,c,d,e,f) { printf "facet normal 0 0 1\n outer loop\n  vertex %.15g %.15g 0\n  vertex %.15g %.15g 0\n  vertex %.15g %.15g 0\n endloop\nendfacet\n",a,b,c,d,e,f }
BEGIN { print "solid plate"
  for (i = 0; i < 20; i++) for (j = 0; j < 20; j++) {
    tri(v(i),v(j),v(i+1),v(j),v(i+1),v(j+1)); tri(v(i),v(j),v(i+1),v(j+1),v(i),v(j+1)) }
  print "endsolid plate" }' > "$1"
