# Mass flow through the outlet over time.
# Called by powderlink flow, which sets: table, output, mean_flow (kg/s), rms, floor (%, -1: unknown),
# average_ms.
set output output
set datafile separator ","
set datafile missing ""
set xlabel "time {/:Italic t} (ms)"
set ylabel "flow through the outlet (g/s)"
set key outside above horizontal Left reverse maxrows 1 width 1
set autoscale xfix
set yrange [* < 0 : *]
set offsets 0, 0, graph 0.08, 0
if (rms >= 0) { set label 1 sprintf("mean %.4g g/s, RMS %.3g %%, by chance %.3g %%", 1e3*mean_flow, rms, floor) at graph 0.97, graph 0.07 right }
plot table using (1e3*column('time_s')):(1e3*column('flow_kg_s')) with lines linestyle 1 title sprintf("average over %g ms", average_ms), \
  1e3*mean_flow with lines linestyle 5 title "mean"
set output
