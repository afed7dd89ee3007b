#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# LIGGGHTS 3.8.0 (Debian package liggghts): the rates of fix massflow/mesh, f_ID[3] and f_ID[4], are means since they
# were last looked at by anybody. A thermo line that prints one of them every 10 steps makes what another output
# reads every 100 steps a mean over 10: here one grain crosses in 100 steps, and the rate says 1 or 0.
# Fails (status 1) if that changes.
set -euo pipefail
version=$(dpkg-query -W -f '${Version}' liggghts)
work=$(mktemp -d); trap 'rm -rf "$work"' EXIT; cd "$work"
cat >plate.stl <<'STL'
solid plate
facet normal 0 0 1
outer loop
vertex -1 -1 0
vertex 1 -1 0
vertex 0 1.5 0
endloop
endfacet
endsolid plate
STL
script() {  # file, quantities of the thermo lines
  cat >"$1" <<LIGGGHTS
units si
atom_style granular
atom_modify map array
boundary f f f
newton off
communicate single vel yes
region box block -0.1 0.1 -0.1 0.1 -0.1 0.1 units box
create_box 1 box
neighbor 0.01 bin
neigh_modify delay 0
fix m1 all property/global youngsModulus peratomtype 5e6
fix m2 all property/global poissonsRatio peratomtype 0.3
fix m3 all property/global coefficientRestitution peratomtypepair 1 0.9
fix m4 all property/global coefficientFriction peratomtypepair 1 0.3
pair_style gran model hertz tangential history
pair_coeff * *
timestep 1e-5
create_atoms 1 single 0 0 0.0015 units box
set group all diameter 0.01 density 2500 vz -5
fix integrate all nve/sphere
fix plate all mesh/surface/planar file plate.stl type 1
fix through all massflow/mesh mesh plate vec_side 0 0 -1 count once
variable number equal f_through[2]
variable rate equal f_through[4]*100*1e-5
fix see all print 100 "SEEN \${number} \${rate}" screen yes
thermo_style custom step $2
thermo 10
run 100
LIGGGHTS
}
script in.alone atoms
script in.looked f_through[4]
alone=$(liggghts -in in.alone | awk '/^SEEN/ { printf "%d %.6g\n", $2, $3 }')
looked=$(liggghts -in in.looked | awk '/^SEEN/ { printf "%d %.6g\n", $2, $3 }')
echo "liggghts $version; number that passed, rate times interval: alone $alone; with the rate in thermo lines too: $looked"
[[ $alone == "1 1" && $looked == "1 0" ]]
