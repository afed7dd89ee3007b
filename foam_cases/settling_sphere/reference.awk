# awk -f reference.awk post/particles_*.dump
# Falling spheres against m dv/dt = (m - rho V) g - 3 pi mu d (1 + 0.15 Re^0.687) v, from rest, by
# Runge-Kutta of fourth order. Per sphere: diameter [um], last velocity, largest deviation over the
# terminal velocity.
function acceleration(v, d,   re) {
  re = d*v*rho/mu
  return g*(1 - rho/rho_p) - 18*mu*(re > 0 ? 1 + 0.15*exp(0.687*log(re)) : 1)*v/(rho_p*d*d)
}
function fall(d, time,   n, h, v, i, a, b, c, e) {
  n = int(time/step_s + 0.5)
  if (n == 0) return 0
  h = time/n
  for (i = 0; i < n; i++) {
    a = acceleration(v, d)
    b = acceleration(v + 0.5*h*a, d)
    c = acceleration(v + 0.5*h*b, d)
    e = acceleration(v + h*c, d)
    v += h*(a + 2*b + 2*c + e)/6
  }
  return v
}
BEGIN {
  g = 9.81; rho = 1.66; mu = 2.23e-5; rho_p = 7950
  dem_step_s = 1e-5
  step_s = 2e-4       # a fortieth of the smallest sphere's relaxation time
  long_s = 2          # all have their terminal velocity
}
/^ITEM: TIMESTEP/ { getline; time = $1*dem_step_s; rows = 0; next }
/^ITEM: ATOMS/ { rows = 1; next }
/^ITEM/ { rows = 0 }
rows {
  um = sprintf("%.0f", 2e6*$9)
  d = um*1e-6
  if (!(um in terminal)) terminal[um] = fall(d, long_s)
  v = -$8
  off = (v - fall(d, time))/terminal[um]
  if (off < 0) off = -off
  if (off > worst[um] + 0) worst[um] = off
  if (time >= latest[um] + 0) { latest[um] = time; last[um] = v }
}
END { for (um in last) printf "%d %.6f %.3e\n", um, last[um], worst[um] }
