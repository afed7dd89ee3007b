#!/usr/bin/env bash
# make_stl.sh FOLDER: sites.stl, outlet.stl.
# sites: 61 small triangles in hexagonal order, 0.138 mm apart, so that the largest grains (0.11 mm)
# on neighbouring sites do not touch each other nor the wall (radius 0.625 mm).
set -euo pipefail
mkdir -p "$1"
triangle='function triangle(x1, y1, x2, y2, x3, y3) {
  printf "facet normal 0 0 1\n outer loop\n  vertex %.9g %.9g 0\n  vertex %.9g %.9g 0\n  vertex %.9g %.9g 0\n endloop\nendfacet\n", x1, y1, x2, y2, x3, y3 }'
awk -v apart=1.38e-4 -v rings=4 -v size=2e-6 "$triangle"'
  BEGIN {
    print "solid sites"
    for (i = -rings; i <= rings; i++)
      for (j = -rings; j <= rings; j++) {
        if (i + j > rings || i + j < -rings) continue
        x = apart*(i + j/2); y = apart*j*sqrt(3)/2
        triangle(x - size, y - size, x + size, y - size, x, y + size)
      }
    print "endsolid sites"
  }' >"$1/sites.stl"
awk -v half=6.3e-4 "$triangle"'
  BEGIN {
    print "solid outlet"
    triangle(-half, -half, half, -half, half, half)
    triangle(-half, -half, half, half, -half, half)
    print "endsolid outlet"
  }' >"$1/outlet.stl"
