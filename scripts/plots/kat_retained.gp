# Retained fraction over diameter: classes with 95 % bars, the fit, d_c with its interval.
# Called by powderlink kat analyse, which sets: table (classes), curve (fit), output, d_c, d_low, d_high.
set output output
set datafile separator ","
set logscale x
set xlabel "diameter {/:Italic d} (µm)"
set ylabel "retained fraction"
stats table using 'low_um' nooutput
x_low = STATS_min
stats table using 'high_um' nooutput
x_high = STATS_max
set xrange [0.97 * x_low : 1.03 * x_high]
set xtics (1, 2, 3, 5, 7, 10, 15, 20, 30, 40, 50, 70, 100, 150, 200, 300, 500, 1000) scale 0.9
set yrange [0 : 1.8]
set key outside above center horizontal Left reverse
set object 1 rectangle from first d_low, graph 0 to first d_high, graph 1 fillcolor rgb "#777777" fillstyle transparent solid 0.18 noborder behind
set arrow 1 from first d_c, graph 0 to first d_c, graph 1 nohead linestyle 5 back
set label 1 sprintf("{/:Italic d}_c = %.3g µm (%.3g to %.3g)", d_c, d_low, d_high) at graph 0.98, graph 0.95 right textcolor rgb "#555555"
# Bars end below the label, but hold their point.
top(y, point) = y < 1.6 ? y : point > 1.6 ? point : 1.6
plot table using 'middle_um':'retained_low':(0):(top(column('retained_high'), column('retained')) - column('retained_low')) with vectors heads nofilled size graph 0.008,90 linestyle 4 linewidth 1.3 notitle, \
  table using 'middle_um':'retained' with points linestyle 4 pointtype 7 pointsize 0.7 title "counted", \
  curve using 'diameter_um':'retained' with lines linestyle 1 title "fit"
set output
