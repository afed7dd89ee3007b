#!/usr/bin/env bash
# make_stl.sh FOLDER DISK PITCH: sites.stl, outlet.stl.
# sites: small triangles in hexagonal order, PITCH [m] apart, on a disk of diameter DISK [m]; inputs.sh
# has made sure that the largest grains on neighbouring sites do not touch each other nor the wall.
set -euo pipefail
mkdir -p "$1"
triangle='function triangle(x1, y1, x2, y2, x3, y3) {
  printf "facet normal 0 0 1\n outer loop\n  vertex %.9g %.9g 0\n  vertex %.9g %.9g 0\n  vertex %.9g %.9g 0\n endloop\nendfacet\n", x1, y1, x2, y2, x3, y3 }'
awk -v apart="$3" -v disk="$2" -v size=2e-6 "$triangle"'
  BEGIN {
    print "solid sites"
    # In units of the pitch; a point on the rim belongs to the disk.
    radius = disk/2/apart*(1 + 1e-9)
    most = int(radius*2/sqrt(3))
    for (i = -most; i <= most; i++)
      for (j = -most; j <= most; j++) {
        if (i^2 + i*j + j^2 > radius^2) continue
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
