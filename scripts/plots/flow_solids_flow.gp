# Solids flow through a slice over time, as dumped and averaged.
# Called by powderlink flow, which sets: table, output, mean_flow (kg/s), rms (%, -1: unknown),
# average_ms, from_s.
set output output
set datafile separator ","
set datafile missing ""
set xlabel "time {/:Italic t} (ms)"
set ylabel "solids flow (g/s)"
set key outside above horizontal Left reverse maxrows 1 width 1
set autoscale xfix
if (mean_flow > 0) { set yrange [0 : *] }
set offsets 0, 0, graph 0.08, 0
if (rms >= 0) { set label 1 sprintf("mean %.4g g/s, RMS %.3g %%", 1e3*mean_flow, rms) at graph 0.97, graph 0.07 right }
plot table using (1e3*column('time_s')):(1e3*column('solids_flow_kg_s')) with lines linewidth 1.0 linecolor rgb "#9DB7D5" title "each dump", \
  1e3*mean_flow with lines linestyle 5 title "mean", \
  table using (1e3*column('time_s')):(1e3*column('moving_average_kg_s')) with lines linestyle 1 title sprintf("average over %g ms", average_ms)
set output
