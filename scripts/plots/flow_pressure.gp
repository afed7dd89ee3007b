# Pressure along the pipe and the fit whose slope is reported.
# Called by powderlink flow, which sets: table, output, axis (x, y or z), slope along it (Pa/m,
# 0: no fit), intercept (Pa), from_place, to_place (m).
set output output
set datafile separator ","
set xlabel "{/:Italic ".axis."} (mm)"
set ylabel "pressure {/:Italic p} (kPa)"
set key top right
stats table using (column(axis.'_m')) nooutput
low = from_place > STATS_min ? from_place : STATS_min
high = to_place < STATS_max ? to_place : STATS_max
fit_kPa(mm) = mm >= 1e3*low && mm <= 1e3*high ? 1e-3*(intercept - slope*1e-3*mm) : NaN
set samples 1000
set xrange [* < 0 : *]
set autoscale xfixmax
set offsets 0, graph 0.03, graph 0.06, 0  # no point on the frame
slope_text = abs(slope) >= 1000 ? sprintf("%.0f", slope) : sprintf("%.4g", slope)
if (slope != 0) {
  plot table using (1e3*column(axis.'_m')):(1e-3*column('pressure_Pa')) with points linestyle 3 title "probes", \
    fit_kPa(x) with lines linestyle 1 title sprintf("fit: %s Pa/m", slope_text)
} else {
  plot table using (1e3*column(axis.'_m')):(1e-3*column('pressure_Pa')) with points linestyle 3 title "probes"
}
set output
