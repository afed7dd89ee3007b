#!/usr/bin/env bash
# Sourced by the run.sh of packed_bed and bed_mesh.

bed_density_kg_m3=10

# Pressure drop of the bed by Ergun: 1 mm spheres, void fraction 0.4513, 15.6 mm, nu 1.5e-4 m2/s, at
# 0.002 m/s over the whole cross-section.
ergun_Pa() {
  awk -v rho="$bed_density_kg_m3" 'BEGIN {
    void = 0.4513; d = 1e-3; u = 0.002; mu = rho*1.5e-4
    viscous = 150*mu*(1 - void)^2*u/(void^3*d*d)
    inertial = 1.75*rho*(1 - void)*u*u/(void^3*d)
    printf "%.4f", 0.0156*(viscous + inertial) }'
}

# Last mean kinematic pressure of the inlet, in Pa; the outlet has 0.
pressure_drop_Pa() {
  tail -n 1 postProcessing/inletPressure/0/surfaceFieldValue.dat |
    awk -v rho="$bed_density_kg_m3" '{ printf "%.6f", rho*$2 }'
}
