# awk -f settled.awk DUMP: pressure drop [Pa] at 0.010 m/s of the spheres of a LIGGGHTS dump, from their
# places and Gidaspow's drag alone: "LEAST MOST".
# Volume and drag of each sphere are put into the cell of its centre and spread over the mesh as by
# voidFraction smooth (explicit diffusion to a width of 3 mm at half maximum). In model A a cell then has
#   -dp/dz = S U/alpha^2,   S = sum of K per volume, U superficial velocity
# LEAST: the gas spreads over each layer so that dp/dz is the same there (perfect cross-flow). MOST: it is
# even everywhere. The true flow is between the two (Thomson's and Rayleigh's bounds of a linear network;
# the drag is linear to 0.2 % at Re 0.07).
BEGIN {
  nx = 8; nz = 32; side = 7.991344e-3; height = 32e-3  # caseSettings
  hx = side/nx; hz = height/nz; cell = hx*hx*hz
  d = 1e-3; rho = 10; nu = 1.5e-4; U = 0.010; length_m = 3e-3; pi = 3.14159265358979
}
/^ITEM: ATOMS/ { rows = 1; next }
/^ITEM/ { rows = 0 }
rows { n++; x[n] = $3; y[n] = $4; z[n] = $5 }
function wrap(i) { return (i % nx + nx) % nx }
function at(i, j, k) { return (k*nx + wrap(j))*nx + wrap(i) }
function floor(v,  i) { i = int(v); return i > v ? i - 1 : i }
# Spreads what was put into q.
function spread(q,  i, j, k, c, s, sweeps, gain, cx, cz) {
  cx = length_m^2/(16*log(2))/hx^2; cz = length_m^2/(16*log(2))/hz^2
  sweeps = int((4*cx + 2*cz)/0.5) + 1  # stable
  cx /= sweeps; cz /= sweeps
  for (s = 0; s < sweeps; s++) {
    for (k = 0; k < nz; k++) for (j = 0; j < nx; j++) for (i = 0; i < nx; i++) {
      c = at(i, j, k)
      gain[c] = cx*(q[at(i + 1, j, k)] + q[at(i - 1, j, k)] + q[at(i, j + 1, k)] + q[at(i, j - 1, k)] - 4*q[c])
      if (k > 0) gain[c] += cz*(q[c - nx*nx] - q[c])
      if (k < nz - 1) gain[c] += cz*(q[c + nx*nx] - q[c])
    }
    for (c = 0; c < nx*nx*nz; c++) q[c] += gain[c]
  }
}
function void_at(p,  a, b, c, i, j, k, fx, fy, fz, w, sum) {  # linear between centres of cells
  fx = x[p]/hx - 0.5; fy = y[p]/hx - 0.5; fz = z[p]/hz - 0.5
  if (fz < 0) fz = 0
  i = floor(fx); j = floor(fy); k = floor(fz); fx -= i; fy -= j; fz -= k
  for (a = 0; a < 2; a++) for (b = 0; b < 2; b++) for (c = 0; c < 2; c++) {
    w = (a ? fx : 1 - fx)*(b ? fy : 1 - fy)*(c ? fz : 1 - fz)
    sum += w*(1 - solid[at(i + a, j + b, k + c)])
  }
  return sum
}
function drag(void,  re, f) {  # K [kg/s]
  re = d*U/nu
  if (void < 0.8) f = (150*(1 - void) + 1.75*re)/(18*void)
  else f = (1 + 0.15*re^0.687)*void^-2.65
  return 3*pi*rho*nu*d*f
}
END {
  if (n == 0) { print "none none"; exit 1 }
  for (c = 0; c < nx*nx*nz; c++) solid[c] = resistance[c] = 0
  for (p = 1; p <= n; p++) {
    home[p] = at(floor(x[p]/hx), floor(y[p]/hx), floor(z[p]/hz))
    solid[home[p]] += pi/6*d^3/cell
  }
  spread(solid)
  for (p = 1; p <= n; p++) resistance[home[p]] += drag(void_at(p))/cell
  spread(resistance)
  for (k = 0; k < nz; k++) {
    mobility = sum = 0
    for (c = k*nx*nx; c < (k + 1)*nx*nx; c++) {
      r = resistance[c]/(1 - solid[c])^2
      sum += r
      mobility += 1/(r + 1e-30)
    }
    least += U*hz*nx*nx/mobility
    most += U*hz*sum/(nx*nx)
  }
  printf "%.4f %.4f\n", least, most
}
