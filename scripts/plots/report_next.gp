# What the leading explanations predict beyond the measurements, and where to measure next.
# Called by powderlink report, which sets: table (measured rows), curves (a column per explanation),
# points (predictions at the proposed velocity), output, scripts, n_curves, names (separated by
# blanks), next_v (m/s, 0: none), n_rows (0: no critical diameters), x_low, x_high, y_low, y_high.
set output output
set datafile separator ","
set xlabel "impact velocity {/:Italic v} (m/s)"
set ylabel "critical diameter {/:Italic d}_c (µm)"
load scripts . '/log_axes.gp'
set key outside above center horizontal maxrows 2 Left reverse width 1 noenhanced
set style fill transparent solid 0.18 noborder
array colours[6] = ["#4477AA", "#AA3377", "#009988", "#BB9911", "#777777", "#1A1A1A"]
array dashes[6] = ["1", "(10,5)", "(3,3)", "(12,4,3,4)", "(2,5)", "(16,6)"]
if (next_v > 0) {
  set arrow 1 from next_v, graph 0 to next_v, graph 1 nohead linecolor rgb ink linewidth 1.4 dashtype (6,4) back
  # d_c falls with velocity: free are the corner below left and the one above right.
  if (next_v * next_v < x_low * x_high) { set label 1 sprintf(" next: %.3g m/s", next_v) at next_v, graph 0.05 left font ",15" } \
  else { set label 1 sprintf("next: %.3g m/s ", next_v) at next_v, graph 0.95 right font ",15" }
}
command = ""
do for [i=1:n_curves] {
  command = command . sprintf("curves using 'velocity_m_s':'low_%d':'high_%d' with filledcurves linecolor rgb '%s' notitle, ", i, i, colours[i])
  command = command . sprintf("curves using 'velocity_m_s':'diameter_%d' with lines linewidth 2 linecolor rgb '%s' dashtype %s title '%s', ", i, colours[i], dashes[i], word(names, i))
}
if (next_v > 0) {
  command = command . "points using 'velocity_m_s':'diameter_um' with points pointtype 9 pointsize 1.4 linecolor rgb ink title 'at the proposed drop', "
  command = command . "points using 'velocity_m_s':'diameter_um':'hover' with labels hypertext point pointtype 7 pointsize 1.6 linecolor rgb '#FF1A1A1A' notitle, "
}
if (n_rows > 0) {
  command = command . "table using 'x':(column('measured')-column('sigma')):(0):(2*column('sigma')) with vectors heads nofilled size graph 0.011,90 linestyle 4 notitle, "
  command = command . "table using 'x':'measured' with points linestyle 4 pointtype 7 pointsize 0.7 title 'measured', "
  command = command . "table using 'x':'measured':'hover' with labels hypertext point pointtype 7 pointsize 1.6 linecolor rgb '#FFEE7733' notitle, "
}
eval "plot " . command[1:strlen(command) - 2]
set output
