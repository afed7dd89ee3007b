# Lowest and highest centre of a particle in a hundred bins along the channel.
# Called by powderlink flow, which sets: table, output, axis, up.
set output output
set datafile separator ","
set datafile missing ""
set xlabel "{/:Italic ".axis."} (mm)"
set ylabel "height {/:Italic ".up."} (mm)"
set key outside above horizontal Left reverse maxrows 1 width 1
set autoscale xfix
set offsets 0, 0, graph 0.05, graph 0.05
plot table using (1e3*column(axis.'_m')):(1e3*column(up.'_lowest_m')):(1e3*column(up.'_highest_m')) with filledcurves linecolor rgb "#D6E0EC" title "all", \
  table using (1e3*column(axis.'_m')):(1e3*column(up.'_highest_m')) with lines linewidth 2 linecolor rgb attached_colour title "highest", \
  table using (1e3*column(axis.'_m')):(1e3*column(up.'_lowest_m')) with lines linewidth 2 linecolor rgb detached_colour title "lowest"
set output
