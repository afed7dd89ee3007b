# Particles and their velocity over the height, in the part that counts.
# Called by powderlink flow, which sets: table, output, up, axis.
set output output
set datafile separator ","
set datafile missing ""
set ylabel "height {/:Italic ".up."} (mm)"
set xlabel "share of the particles per height (1/mm)" textcolor rgb attached_colour
set x2label "velocity {/:Italic v}_".axis." (m/s)" textcolor rgb detached_colour
set xtics nomirror
set x2tics
set autoscale yfix
set xrange [0 : *]
set x2range [* < 0 : 0 < *]
set offsets graph 0.03, graph 0.03, 0, 0
set key off
shown(value, count) = count >= enough ? value : NaN
plot table using (1e-3*column('share_1_m')):(1e3*column(up.'_m')) with lines linewidth 2 linecolor rgb attached_colour, \
  table using (shown(column('velocity_mean_m_s'),column('count'))):(1e3*column(up.'_m')) axes x2y1 with points pointtype 7 pointsize 0.7 linecolor rgb detached_colour
set output
