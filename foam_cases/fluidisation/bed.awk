# awk -v height=HEIGHT -f bed.awk: for spheres whose centre of mass rests at HEIGHT [m]: weight less
# buoyancy per area [Pa], expansion of an even bed at 0.020 m/s [1].
function gradient(void, u) {  # Ergun, or beyond void 0.8 not valid
  return 150*mu*(1 - void)^2*u/(void^3*d*d) + 1.75*rho*(1 - void)*u*u/(void^3*d)
}
BEGIN {
  n = 1044; d = 1e-3; side = 7.991344e-3; rho_p = 2000; rho = 10; mu = rho*1.5e-4; g = 9.81
  solid = n*3.14159265358979/6*d^3/(side*side)  # height of the spheres' volume
  weight = solid*(rho_p - rho)*g
  bed = 2*height
  void = 1 - solid/bed
  low = void; high = 0.8
  for (i = 0; i < 60; i++) {
    v = 0.5*(low + high)
    if (gradient(v, 0.020) > (1 - v)*(rho_p - rho)*g) low = v; else high = v
  }
  printf "%.4f %.6f\n", weight, (1 - void)/(1 - v)
}
