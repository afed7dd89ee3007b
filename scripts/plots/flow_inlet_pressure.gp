# Pressure at the inlet over time, with the straight pieces that meet at its elbow.
# Called by powderlink flow, which sets: table, output, elbow_s (-1: none), low_s, high_s.
set output output
set datafile separator ","
set datafile missing ""
set xlabel "time {/:Italic t} (ms)"
set ylabel "pressure at the inlet (kPa)"
set key outside above horizontal Left reverse maxrows 1 width 1
set autoscale xfix
set offsets 0, 0, graph 0.08, graph 0.08
# Strokes of grains that appear at once would hide the rest.
stats table using (1e-3*column('pressure_Pa')) nooutput
far = 8*(STATS_up_quartile - STATS_lo_quartile)
top = STATS_up_quartile + far < STATS_max ? STATS_up_quartile + far : STATS_max
bottom = STATS_lo_quartile - far > STATS_min ? STATS_lo_quartile - far : STATS_min
if (top > bottom) { set yrange [bottom < 0.3*top && bottom > 0 ? 0 : bottom : top] }
if (elbow_s > 0) {
  set object 1 rectangle from first 1e3*low_s, graph 0 to first 1e3*high_s, graph 1 behind fillcolor rgb "#EEEEEE" fillstyle solid noborder
  set label 1 sprintf("%.4g ms", 1e3*elbow_s) at first 1e3*elbow_s, graph 0.05 offset 0.7,0
  plot table using (1e3*column('time_s')):(1e-3*column('pressure_Pa')) with lines linewidth 1.0 linecolor rgb "#9DB7D5" title "pressure", \
    table using (1e3*column('time_s')):(1e-3*column('fit_Pa')) with lines linestyle 1 title "straight pieces"
} else {
  plot table using (1e3*column('time_s')):(1e-3*column('pressure_Pa')) with lines linewidth 1.0 linecolor rgb "#4477AA" title "pressure"
}
set output
