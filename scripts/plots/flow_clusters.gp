# Clusters over place and time; the longer, the larger the circle.
# Called by powderlink flow, which sets: table, output, axis.
set output output
set datafile separator ","
set xlabel "{/:Italic ".axis."} of the cluster (mm)"
set ylabel "time {/:Italic t} (ms)"
set cblabel "velocity {/:Italic v}_".axis." (m/s)"
set palette defined (0 "#14283F", 0.5 "#4477AA", 1 "#EE7733")
set rmargin 8.5
set key off
stats table using (1e3*column('length_m')) nooutput
longest = STATS_max
set label 1 sprintf("largest: %.3g mm", longest) at graph 0.98, graph 1.04 right
set offsets graph 0.03, graph 0.03, graph 0.03, graph 0.03
plot table using (1e3*column(axis.'_m')):(1e3*column('time_s')):(0.4+2.0*1e3*column('length_m')/longest):(column('velocity_m_s')) with points pointtype 7 pointsize variable linecolor palette
set output
