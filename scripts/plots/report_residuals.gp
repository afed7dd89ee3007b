# Residuals in standard deviations against one column; within the grey band the model fits.
# Called by powderlink report, which sets: table, output, x_title, x_low, x_high, y_high (largest
# residual), n_dem.
set terminal svg size 430,330 @look
# One frame for all columns, so that panels beside each other match.
set lmargin at screen 0.19
set rmargin at screen 0.96
set bmargin at screen 0.23
set tmargin at screen n_dem > 0 ? 0.87 : 0.96
set xtics tic_step(x_low, x_high)
set mxtics 2
set output output
set datafile separator ","
set xlabel x_title noenhanced
set ylabel "(model − measured)/σ"
set xrange [x_low - 0.06 * (x_high - x_low) : x_high + 0.06 * (x_high - x_low)]
y_end = 1.15 * (y_high > 3 ? y_high : 3)
set yrange [-y_end : y_end]
set object 1 rectangle from graph 0, first -2 to graph 1, first 2 fillcolor rgb "#777777" fillstyle transparent solid 0.14 noborder behind
set arrow 1 from graph 0, first 0 to graph 1, first 0 nohead linestyle 5 back
if (n_dem > 0) { set key outside above center horizontal Left reverse } else { unset key }
dem_plot = n_dem > 0 ? \
  ", table using 'x':'dem_residual_sigma' with points linestyle 3 pointtype 6 pointsize 1.3 title 'LIGGGHTS', table using 'x':'dem_residual_sigma':'dem_hover' with labels hypertext point pointtype 7 pointsize 1.6 linecolor rgb '#FF4477AA' notitle" : ""
eval "plot table using 'x':(0):(0):'residual_sigma' with vectors nohead linecolor rgb '#009988' linewidth 1.6 notitle, " . \
  "table using 'x':'residual_sigma' with points pointtype 7 pointsize 1.0 linecolor rgb '#009988' title 'model', " . \
  "table using 'x':'residual_sigma':'hover' with labels hypertext point pointtype 7 pointsize 1.6 linecolor rgb '#FF009988' notitle" . dem_plot
set output
