# RMS deviation of the flow through the outlet over the window, and what independent grains give.
# Called by powderlink flow, which sets: table, output.
set output output
set datafile separator ","
set xlabel "window of the average {/:Italic w} (ms)"
set ylabel "RMS deviation of the flow (%)"
set key bottom left reverse Left
stats table using (1e3*column('window_s')) nooutput
x_low = STATS_min; x_high = STATS_max
stats table using 'high_percent' nooutput
y_high = STATS_max
stats table using 'floor_percent' nooutput
y_low = STATS_min
stats table using 'low_percent' nooutput
y_low = STATS_min < y_low ? STATS_min : y_low
load scripts."/log_axes.gp"
plot table using (1e3*column('window_s')):'low_percent':'high_percent' with filledcurves linecolor rgb "#D6E0EC" title "95 % interval", \
  table using (1e3*column('window_s')):'rms_percent' with linespoints linestyle 3 title "flow through the outlet", \
  table using (1e3*column('window_s')):'floor_percent' with lines linestyle 5 title "independent grains"
set output
