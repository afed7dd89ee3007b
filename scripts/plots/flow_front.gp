# Where the grains have lost half of their excess velocity, over time.
# Called by powderlink flow, which sets: table, output, axis.
set output output
set datafile separator ","
set xlabel "time {/:Italic t} (ms)"
set ylabel "front {/:Italic ".axis."} (mm)"
set key off
set autoscale xfix
set yrange [* < 0 : 0 < *]
set offsets 0, 0, graph 0.08, 0
plot table using (1e3*column('time_s')):(1e3*column(axis.'_m')) with linespoints linestyle 3
set output
