# Height of the particles along the pipe: median and the intervals that hold 50 and 90 %.
# Called by powderlink flow, which sets: table, output.
set output output
set datafile separator ","
set datafile missing "nan"
set xlabel "{/:Italic ".axis."} (mm)"
set ylabel "height {/:Italic ".up."} (mm)"
set key outside above horizontal Left reverse maxrows 1 width 1
set autoscale xfix
# A percentile of a handful of particles says nothing.
mm(value, count) = count >= enough ? 1e3*value : NaN
plot table using (1e3*column(axis.'_m')):(mm(column(up.'_05_m'),column('count'))):(mm(column(up.'_95_m'),column('count'))) with filledcurves linecolor rgb "#D6E0EC" title "90 %", \
  table using (1e3*column(axis.'_m')):(mm(column(up.'_25_m'),column('count'))):(mm(column(up.'_75_m'),column('count'))) with filledcurves linecolor rgb "#9DB7D5" title "50 % of the particles", \
  table using (1e3*column(axis.'_m')):(mm(column(up.'_50_m'),column('count'))) with lines linestyle 1 title "median"
set output
