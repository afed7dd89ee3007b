# Speed after the stop over diameter, one run: every particle, and the closed form of an instant stop
#   v_res = sqrt(v^2 - 2 W/m) = v sqrt(1 - (d_c/d)^(5/3))      (W ~ d^(4/3), m ~ d^3)
# Called by plot.sh, which sets: table (powderlink-render table), output, v (m/s), d_c (um, 0 when
# unknown), x_low, x_high (um), y_high (m/s).
set output output
set datafile separator ","
set datafile commentschars "#"
set xlabel "diameter {/:Italic d} (µm)"
set ylabel "speed away from the plate {/:Italic v}_{res} (m/s)"
pad = 0.05 * (x_high - x_low > 0 ? x_high - x_low : x_high)
set xrange [x_low - pad : x_high + pad]
top = (y_high > v ? y_high : v) * 1.12
set yrange [-0.05 * top : top]
set samples 2000
set key outside above horizontal left Left reverse maxrows 2 samplen 2.5 width 2
residual(d) = d > d_c ? v * sqrt(1.0 - (d_c / d) ** (5.0 / 3.0)) : NaN
set label 1 "impact velocity {/:Italic v}" at graph 0.02, first v offset 0, 0.7 left textcolor rgb "#555555"
if (d_c > 0) {
  set arrow 1 from first d_c, graph 0 to first d_c, first v nohead linestyle 5
  set label 2 sprintf("{/:Italic d}_c = %.1f µm", d_c) at first d_c, first 0.62 * v offset -0.7, 0 right textcolor rgb "#555555"
}
below(a, s) = a > 0.5 ? s : NaN
above(a, s) = a > 0.5 ? NaN : s
plot v with lines linestyle 5 notitle, \
  table using 'diameter_um':(above(column('attached'), column('speed_m_s'))) with points pointtype 7 pointsize 0.55 linecolor rgb detached_colour title "detached (DEM)", \
  table using 'diameter_um':(below(column('attached'), 0.0)) with points pointtype 7 pointsize 0.55 linecolor rgb attached_colour title "attached (DEM)", \
  (d_c > 0 ? residual(x) : NaN) with lines linestyle 1 linewidth 1.2 title "instant stop, {/:Italic v} [1 − ({/:Italic d}_c / {/:Italic d})^{5/3}]^{1/2}"
set output
