# awk -v from=STEP -v last=STEP -v radius=R -f window.awk post/window.dump
# What the camera sees: the frames of the steps from .. last, of the 3 mm around half of
# the length. A grain counts once in each frame, so that it weighs as its time in the window does.
# Prints: frames, grains in a frame, mean velocity along the pipe [m/s], its standard error, standard
# deviation of the grains, the same three of the height above the bottom [m], mass flow, sum(m v)/3 mm
# [kg/s], its standard error. The errors are those of 20 blocks of frames, so that a grain that is seen
# many times, and bunches of grains, count as they should.
/^ITEM: TIMESTEP/ { rows = 0; getline; step = $1; seen = step >= from && step <= last
  if (seen) {
    b = int((step - from)/(last - from)*blocks); if (b == blocks) b--
    time[b] += 0.003; frames++
  }
  next
}
/^ITEM: ATOMS/ { split("", column); for (i = 3; i <= NF; i++) column[$i] = i - 2; rows = 1; next }
/^ITEM:/ { rows = 0; next }
rows && seen {
  v = $column["vz"]; h = $column["y"] + radius
  n[b]++; sv[b] += v; sh[b] += h; flow[b] += $column["mass"]*v
  grains++; svv += v*v; shh += h*h
}
# Standard error of the ratio of two sums over blocks.
function ratio(top, bottom,  b, t, u, s, r) {
  for (b = 0; b < blocks; b++) { t += top[b]; u += bottom[b] }
  r = t/u
  for (b = 0; b < blocks; b++) s += (top[b] - r*bottom[b])^2
  error = sqrt(s*blocks/(blocks - 1))/u
  return r
}
BEGIN { blocks = 20 }
END {
  if (!grains) exit 1
  v = ratio(sv, n); v_error = error
  h = ratio(sh, n); h_error = error
  m = ratio(flow, time); m_error = error
  printf "%d %.3f %.4f %.4f %.4f %.5g %.5g %.5g %.5g %.5g\n", frames, grains/frames, v, v_error, \
    sqrt(svv/grains - v*v), h, h_error, sqrt(shh/grains - h*h), m, m_error
}
