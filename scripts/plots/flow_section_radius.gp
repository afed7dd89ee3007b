# Particles per area and their velocity over the distance from the axis, in the part that counts.
# Called by powderlink flow, which sets: table, output, axis.
set output output
set datafile separator ","
set datafile missing ""
set xlabel "distance from the axis {/:Italic r} (mm)"
set ylabel "share of the particles per area (1/mm²)" textcolor rgb attached_colour
set y2label "velocity {/:Italic v}_".axis." (m/s)" textcolor rgb detached_colour
set ytics nomirror
set y2tics
set xrange [0 : *]
set autoscale xfixmax
set yrange [0 : *]
set y2range [* < 0 : 0 < *]
set offsets 0, 0, graph 0.05, 0
set key off
shown(value, count) = count >= enough ? value : NaN
plot table using (1e3*column('r_m')):(1e-6*column('share_1_m2')) with lines linewidth 2 linecolor rgb attached_colour, \
  table using (1e3*column('r_m')):(shown(column('velocity_mean_m_s'),column('count'))) axes x1y2 with points pointtype 7 pointsize 0.7 linecolor rgb detached_colour
set output
