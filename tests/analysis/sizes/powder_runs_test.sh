#!/usr/bin/env bash
# powder_runs_test.sh liggghts|openfoam POWDERLINK LIGGGHTS WORK: what `powderlink psd` writes, drawn by
# the host programs themselves, has the shares of the table by number and by mass.
#
# The powder: 45 % dust around 3 um, 35 % of 20 um, 20 % around 60 um. Between these there are no grains,
# so that shares finer than 10 and 40 um do not mind how fine the classes are. Bounds are 4 standard
# deviations of drawing: share s by number  s (1 - s)/N,
#                        by mass            sum (d^3 ([d < D] - s))^2/(sum d^3)^2, of the table, over N.
set -euo pipefail
test=$1 powderlink=$2 liggghts=$3 work=$4/powder_$1
drawn=4000
rm -rf "$work"
mkdir -p "$work"
cd "$work"

awk 'BEGIN {
  srand(5)
  print "area_um2,perimeter_um"
  for (i = 0; i < 2000; i++) {
    d = i < 900 ? 3*exp(0.25*(rand() + rand() + rand() - 1.5)) : i < 1600 ? 20 : 60 + 8*(rand() - 0.5)
    printf "%.9g,%.9g\n", 0.785398163397448*d*d, 3.14159265358979*d
  }
}' >table.csv
"$powderlink" psd table.csv --pixel-size-um 1 --density-kg-m3 8000 --no-figures --out powder >psd.log 2>&1

drawn_by_liggghts() {
  cat >in.draw <<'EOF'
units si
atom_style granular
atom_modify map array
boundary f f f
newton off
communicate single vel yes
region box block 0 8e-3 0 8e-3 0 8e-3 units box
create_box 1 box
neighbor 1e-5 bin
fix m1 all property/global youngsModulus peratomtype 5e6
fix m2 all property/global poissonsRatio peratomtype 0.3
fix m3 all property/global coefficientRestitution peratomtypepair 1 0.9
fix m4 all property/global coefficientFriction peratomtypepair 1 0.1
pair_style gran model hertz tangential history
pair_coeff * *
timestep 1e-9
include powder/in.powder
EOF
  echo "fix ins all insert/pack seed 100003 distributiontemplate powder insert_every once &
    overlapcheck yes all_in yes particles_in_region $drawn region box
run 1
dump d all custom 1 grains.dump radius
run 0" >>in.draw
  timeout 60 "$liggghts" -in in.draw >liggghts.log 2>&1 || { tail -20 liggghts.log; exit 1; }
  awk '/ITEM: ATOMS/ { n = NR } n && NR > n { print 2e6*$1 }' grains.dump >diameters
}

file() { echo "FoamFile { version 2.0; format ascii; class $1; object $2; }"; }

drawn_by_openfoam() {
  mkdir -p 0 constant system
  cp powder/sizeDistribution constant/
  { file dictionary blockMeshDict
    echo 'vertices ((0 0 0) (1 0 0) (1 1 0) (0 1 0) (0 0 1) (1 0 1) (1 1 1) (0 1 1));
      blocks (hex (0 1 2 3 4 5 6 7) (1 1 1) simpleGrading (1 1 1)); boundary ();'; } >system/blockMeshDict
  { file dictionary topoSetDict
    echo 'actions ({ name all; type cellZoneSet; action new; source boxToCell; box (-1 -1 -1) (2 2 2); });'
  } >system/topoSetDict
  { file dictionary controlDict
    echo 'startFrom startTime; startTime 0; stopAt endTime; endTime 1e-3; deltaT 1e-3;
      writeControl timeStep; writeInterval 1; writeFormat ascii; writePrecision 12;'; } >system/controlDict
  { file dictionary fvSchemes
    for schemes in ddt grad div laplacian snGrad; do echo "${schemes}Schemes { default none; }"; done
    echo 'interpolationSchemes { default linear; }'; } >system/fvSchemes
  file dictionary fvSolution >system/fvSolution
  { file dictionary transportProperties; echo 'transportModel Newtonian; rhoInf 1; nu 1e-5;'
  } >constant/transportProperties
  { file dictionary turbulenceProperties; echo 'simulationType laminar;'; } >constant/turbulenceProperties
  { file uniformDimensionedVectorField g; echo 'dimensions [0 1 -2 0 0 0 0]; value (0 0 0);'; } >constant/g
  { file volVectorField U
    echo 'dimensions [0 1 -1 0 0 0 0]; internalField uniform (0 0 0);
      boundaryField { ".*" { type zeroGradient; } }'; } >0/U
  { file dictionary kinematicCloudProperties
    echo "solution { active true; coupled false; transient yes; cellValueSourceCorrection off; maxCo 0.3;
        interpolationSchemes { rho cell; U cell; mu cell; } integrationSchemes { U Euler; } }
      constantProperties { rho0 8000; rhoMin 1e-15; minParcelMass 1e-30; }
      subModels {
        particleForces {}
        injectionModels { all { type cellZoneInjection; cellZone all; numberDensity $drawn;
          U0 (0 0 0); SOI 0; massTotal 0; parcelBasisType fixed; nParticle 1;
          #include \"sizeDistribution\"
        } }
        dispersionModel none; collisionModel none; stochasticCollisionModel none; surfaceFilmModel none;
        patchInteractionModel rebound; reboundCoeffs { e 1; mu 0; UFactor 1; }
      }
      cloudFunctions {}"; } >constant/kinematicCloudProperties
  for program in blockMesh topoSet icoUncoupledKinematicParcelFoam; do
    timeout 60 $program >$program.log 2>&1 || { tail -20 $program.log; exit 1; }
  done
  awk '$1 == "(" { list = 1; next } $1 == ")" { list = 0 } list { print 1e6*$1 }' \
    0.001/lagrangian/kinematicCloud/d >diameters
}

drawn_by_"$test"

awk -F, -v wanted=$drawn '
  function read(d, cube) {
    count[FILENAME]++; mass[FILENAME] += cube; squares[FILENAME] += cube*cube
    for (limit in limits) if (d < limit + 0) {
      finer[FILENAME, limit]++; finer_mass[FILENAME, limit] += cube; finer_squares[FILENAME, limit] += cube*cube
    }
  }
  function compare(what, share, expected, sigma) {
    printf "%s: %.5g, of the table %.5g +- %.2g\n", what, share, expected, sigma
    if (share < expected - 4*sigma || share > expected + 4*sigma) { print "FAILED: " what; bad = 1 }
  }
  BEGIN { limits[10]; limits[40] }
  FILENAME == "table.csv" { if (FNR > 1) { d = sqrt($1/0.785398163397448); read(d, d*d*d) } next }
  { read($1, $1*$1*$1) }
  END {
    t = "table.csv"; g = "diameters"; n = count[g]
    # LIGGGHTS rounds every class by itself.
    if (n < wanted - 40 || n > wanted + 40) { print "FAILED: " n " grains for " wanted; bad = 1 }
    for (limit in limits) {
      s = finer[t, limit]/count[t]
      compare("finer than " limit " um by number", finer[g, limit]/n, s, sqrt(s*(1 - s)/n))
      s = finer_mass[t, limit]/mass[t]
      spread = finer_squares[t, limit]*(1 - s)^2 + (squares[t] - finer_squares[t, limit])*s^2
      compare("finer than " limit " um by mass", finer_mass[g, limit]/mass[g], s, sqrt(spread*count[t]/n)/mass[t])
    }
    m = mass[t]/count[t]
    sigma = sqrt((squares[t]/count[t] - m*m)/n)
    compare("mean of d^3 in um^3", mass[g]/n, m, sigma)
    exit bad
  }' table.csv diameters
