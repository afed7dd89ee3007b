# Grains before and after a drop over their diameter, per area, per class of 10 %.
# Called by powderlink kat analyse, which sets: table (classes), output, d_c, d_low, d_high (um).
set output output
set datafile separator ","
set logscale x
set xlabel "diameter {/:Italic d} (µm)"
set ylabel "grains per area (% of all before, per 10 % of {/:Italic d})"
stats table using 'low_um' nooutput
x_low = STATS_min
stats table using 'high_um' nooutput
x_high = STATS_max
set xrange [0.97 * x_low : 1.03 * x_high]
set xtics (1, 2, 3, 5, 7, 10, 15, 20, 30, 40, 50, 70, 100, 150, 200, 300, 500, 1000) scale 0.9
set yrange [0 : *]
set key outside above center horizontal Left reverse
set style fill transparent solid 0.35 noborder
set object 1 rectangle from first d_low, graph 0 to first d_high, graph 1 fillcolor rgb "#777777" fillstyle transparent solid 0.18 noborder behind
set arrow 1 from first d_c, graph 0 to first d_c, graph 1 nohead linestyle 5 front
set label 1 sprintf("{/:Italic d}_c = %.3g µm", d_c) at first d_c, graph 0.96 offset 0.6, 0 left textcolor rgb "#555555" front
plot table using 'middle_um':(0.5 * column('share_before_percent')):'low_um':'high_um':(0):'share_before_percent' with boxxyerror linecolor rgb detached_colour title "before", \
  '' using 'middle_um':(0.5 * column('share_after_percent')):'low_um':'high_um':(0):'share_after_percent' with boxxyerror linecolor rgb attached_colour title "after"
set output
