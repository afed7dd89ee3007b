# awk -v end_s=T -v exchange_s=D -f reference.awk post/particles_*.dump post/states.dump
# A sphere in u = G y e_x with drag 3 pi mu d (1 + 0.15 Re^0.687) (u - v) and lift
#   1.615 d^2 sqrt(rho mu/G) f (u - v) x curl u,   f = (1 - a) exp(-Re/10) + a,
#   a = 0.3314 sqrt(beta), beta = Re_w/(2 Re), Re_w = G d^2/nu   (Re < 40)
# by Runge-Kutta of fourth order, from the state of the first dump. Lines: name unit value reference.
function forces(y, vx, vy,   sx, sy, re, a) {
  sx = G*y - vx; sy = -vy
  re = d*sqrt(sx*sx + sy*sy)/nu
  a = 0.3314*sqrt(0.5*G*d*d/nu/re)
  k = 3*pi*mu*d*(1 + 0.15*exp(0.687*log(re)))
  lift = 1.615*d*d*sqrt(rho*mu/G)*((1 - a)*exp(-re/10) + a)*G
  # curl u = -G e_z turns the slip (sx, sy) into (-sy, sx)
  ax = (k*sx - lift*sy)/m; ay = (k*sy + lift*sx)/m
  slip = sx
}
function row(name, unit, value, reference) {
  printf "%s %s %.8e %.8e\n", name, unit, value, reference
}
BEGIN {
  pi = 3.14159265358979; rho = 1.66; mu = 2.23e-5; nu = mu/rho; G = 1000; d = 100e-6
  m = 2500*pi/6*d^3
  dem_step_s = 1e-5
}
/^ITEM: TIMESTEP/ { getline; time = $1*dem_step_s; rows = 0; next }
/^ITEM: ATOMS/ { rows = 1; next }
/^ITEM/ { rows = 0 }
# id type x y z vx vy vz radius mass reacting force x, y, drag coefficient
rows && FILENAME !~ /states/ && time < end_s/1e6 { x0 = $3; y0 = $4; vx0 = $6; vy0 = $7 }
# Lift and drag of the end were found one interval before, at the state of then.
rows && FILENAME ~ /states/ && time > end_s - exchange_s - 0.5*dem_step_s && !seen { ye = $2; vxe = $3; vye = $4; seen = 1 }
rows && FILENAME !~ /states/ && time > end_s - 0.5*dem_step_s { x1 = $3; y1 = $4; vx1 = $6; vy1 = $7; fy1 = $12; k1 = $13 }
END {
  steps = 20000; h = end_s/steps
  x = x0; y = y0; vx = vx0; vy = vy0
  for (i = 0; i < steps; i++) {
    ux = vx; uy = vy; forces(y, ux, uy); sx1 = ux; sy1 = uy; ax1 = ax; ay1 = ay
    ux = vx + h/2*ax1; uy = vy + h/2*ay1; forces(y + h/2*sy1, ux, uy); sx2 = ux; sy2 = uy; ax2 = ax; ay2 = ay
    ux = vx + h/2*ax2; uy = vy + h/2*ay2; forces(y + h/2*sy2, ux, uy); sx3 = ux; sy3 = uy; ax3 = ax; ay3 = ay
    ux = vx + h*ax3; uy = vy + h*ay3; forces(y + h*sy3, ux, uy); sx4 = ux; sy4 = uy; ax4 = ax; ay4 = ay
    x += h/6*(sx1 + 2*sx2 + 2*sx3 + sx4); y += h/6*(sy1 + 2*sy2 + 2*sy3 + sy4)
    vx += h/6*(ax1 + 2*ax2 + 2*ax3 + ax4); vy += h/6*(ay1 + 2*ay2 + 2*ay3 + ay4)
  }
  row("path_along", "m", x1 - x0, x - x0)
  row("path_across", "m", y1 - y0, y - y0)
  row("slip_along", "m/s", G*y1 - vx1, G*y - vx)
  row("velocity_across", "m/s", vy1, vy)
  forces(ye, vxe, vye)
  row("lift", "N", fy1, lift*slip)
  row("drag_coefficient", "kg/s", k1, k)
}
