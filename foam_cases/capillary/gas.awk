# awk -v velocity=U -v pipe_length=L -v radius=R -v density=RHO -v viscosity=MU -f gas.awk INLET AXIS
# The gas alone, its mean velocity U; INLET: history of the mean pressure on the inlet, AXIS: of the probes.
# Prints: Re; entrance length [m]; slope of Hagen-Poiseuille, behind half of the length, across the camera's
# 3 mm [Pa/m]; drop [Pa]; entrance loss, which is what it is above Hagen-Poiseuille, and that of a plug by
# Shah [Pa].
#   Hagen-Poiseuille   dp/dz = 32 mu U/D^2
#   entrance length    0.06 Re D
#   Shah               dp = 4 f L/D rho U^2/2, x = L/(D Re),
#                      f Re = 3.44/sqrt(x) + (1.25/(4 x) + 16 - 3.44/sqrt(x))/(1 + 0.00021/x^2)
# Shah's law holds numerical solutions of the boundary layer to 2.4 %, of all x, Re above some 100.
# Source: R. K. Shah, J. Fluids Eng. 100 (1978) 177.
FILENAME == ARGV[1] && !/^#/ { drop = density*$2 }
FILENAME == ARGV[2] && /^# Probe/ { gsub(/[()]/, ""); z[n++] = $NF }
FILENAME == ARGV[2] && !/^#/ { for (i = 0; i < n; i++) p[i] = density*$(i + 2) }
function between(from, to,  i, a, b) {
  for (i = 0; i < n; i++) { if (z[i] - from > -1e-9 && a == "") a = i; if (z[i] - to < 1e-9) b = i }
  return (p[a] - p[b])/(z[b] - z[a])
}
END {
  D = 2*radius; Re = density*velocity*D/viscosity; x = pipe_length/(D*Re)
  developed = 32*viscosity*velocity/D^2
  f = (3.44/sqrt(x) + (1.25/(4*x) + 16 - 3.44/sqrt(x))/(1 + 0.00021/x^2))/Re
  printf "%.0f %.4f %.1f %.1f %.1f %.2f %.2f %.2f\n", Re, 0.06*Re*D, developed, between(pipe_length/2, pipe_length), \
    between(pipe_length/2 - 0.0015, pipe_length/2 + 0.0015), drop, drop - developed*pipe_length, \
    4*f*pipe_length/D*density*velocity^2/2 - developed*pipe_length
}
