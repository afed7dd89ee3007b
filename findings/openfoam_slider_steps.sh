#!/usr/bin/env bash
# The friction of OpenFOAM's colliding clouds (pairSpringSliderDashpot, wallSpringSliderDashpot) is not
# Coulomb's: it grows with collisionResolutionSteps, the accuracy that a user raises in good faith. A slip
# empties the tangential spring, and until that is full again the contact sticks with a dashpot that mu
# does not limit: where it is stronger than mu F_n, more steps mean more of it.
# A sphere of 66 um meets a wall at 0.2 m/s and slides along it at 6.4 m/s, mu 0.52, alpha 0.12: it loses
# mu J_n/m of its speed by Coulomb's law, at 12, 100 and 1000 steps 1.01, 4.71 and 6.67 times as much.
# Debian's openfoam 1912.200626, icoUncoupledKinematicParcelFoam. Fails if that changes.
set -euo pipefail
version=$(dpkg-query -W -f '${Version}' libopenfoam)
[[ $version == 1912* ]] || { echo "seen with 1912.200626, here is $version" >&2; exit 1; }
export WM_PROJECT_DIR=/usr/share/openfoam
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"
mkdir 0 constant system
file() { echo "FoamFile { version 2.0; format ascii; class $1; object $2; }"; }
{ file dictionary blockMeshDict
  echo 'scale 1e-3; vertices ((0 0 0) (2 0 0) (2 1 0) (0 1 0) (0 0 1) (2 0 1) (2 1 1) (0 1 1));
    blocks (hex (0 1 2 3 4 5 6 7) (2 1 1) simpleGrading (1 1 1));
    defaultPatch { name walls; type wall; } boundary ();'; } >system/blockMeshDict
{ file dictionary controlDict
  echo 'startFrom startTime; startTime 0; stopAt endTime; endTime 4e-5; deltaT 1e-6;
    writeControl timeStep; writeInterval 40; writeFormat ascii; writePrecision 12;'; } >system/controlDict
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
    boundaryField { ".*" { type noSlip; } }'; } >0/U
{ file vectorField kinematicCloudPositions; echo '((0.5e-3 0.5e-3 0.0333e-3))'; } >constant/kinematicCloudPositions
cloud() {  # steps per collision
  file dictionary kinematicCloudProperties
  cat <<TEXT
    solution { active true; coupled false; transient yes; cellValueSourceCorrection off; maxCo 0.3;
      interpolationSchemes { rho cell; U cell; mu cell; } integrationSchemes { U Euler; } }
    constantProperties { rho0 7980; rhoMin 1e-15; minParcelMass 1e-30; youngsModulus 2.11e7; poissonsRatio 0.3; }
    subModels {
      particleForces {}
      injectionModels { one { type manualInjection; massTotal 0; parcelBasisType fixed; nParticle 1; SOI 0;
        positionsFile "kinematicCloudPositions"; U0 (6.4 0 -0.2);
        sizeDistribution { type fixedValue; fixedValueDistribution { value 66e-6; } } } }
      dispersionModel none; stochasticCollisionModel none; surfaceFilmModel none;
      patchInteractionModel none;
      collisionModel pairCollision;
      pairCollisionCoeffs { maxInteractionDistance 70e-6; writeReferredParticleCloud no;
        pairModel pairSpringSliderDashpot;
        pairSpringSliderDashpotCoeffs { useEquivalentSize no; alpha 0.12; b 1.5; mu 0.52;
          cohesionEnergyDensity 0; collisionResolutionSteps $1; }
        wallModel wallSpringSliderDashpot;
        wallSpringSliderDashpotCoeffs { useEquivalentSize no; collisionResolutionSteps $1; youngsModulus 2.11e7;
          poissonsRatio 0.3; alpha 0.12; b 1.5; mu 0.52; cohesionEnergyDensity 0; } }
    }
    cloudFunctions {}
TEXT
}
run() { timeout 60 "$1" >"$1.log" 2>&1 || { tail -20 "$1.log" >&2; exit 1; }; }
run blockMesh
for steps in 12 100 1000; do
  cloud $steps >constant/kinematicCloudProperties
  rm -rf 4e-05
  run icoUncoupledKinematicParcelFoam
  awk -v steps=$steps '/^1\(\(/ {
      gsub(/[()]/, " "); printf "%d steps: %.2f times Coulomb\n", steps, (6.4 - $2)/(0.52*(0.2 + $4)) }' \
    4e-05/lagrangian/kinematicCloud/U
done | tee seen
awk '{ seen = seen $3 " " } END { if (seen != "1.01 4.71 6.67 ") { print "changed: " seen; exit 1 } }' seen
