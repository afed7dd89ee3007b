# Width of the stream in x along z: intervals that hold 50, 90 and 99 % of the particles.
# Called by powderlink flow, which sets: table, output.
set output output
set datafile separator ","
set datafile missing "nan"
set xlabel "{/:Italic ".axis."} (mm)"
set ylabel "width of the stream in {/:Italic ".across."} (mm)"
set key outside above horizontal Left reverse maxrows 1 width 1
set autoscale xfix
# A percentile of a handful of particles says nothing.
mm(value, count) = count >= enough ? 1e3*value : NaN
set yrange [0 : *]
set offsets 0, 0, graph 0.08, 0
plot table using (1e3*column(axis.'_m')):(mm(column(across.'_99_m'),column('count'))) with lines linewidth 2 dashtype (3,4) linecolor rgb "#777777" title "99 %", \
  table using (1e3*column(axis.'_m')):(mm(column(across.'_90_m'),column('count'))) with lines linewidth 2 linecolor rgb attached_colour title "90 %", \
  table using (1e3*column(axis.'_m')):(mm(column(across.'_50_m'),column('count'))) with lines linewidth 2 linecolor rgb detached_colour title "50 % of the particles"
set output
