# Measurements of one kind with error bars against the model of a study: curve, band of its fit,
# DEM where it was run. Values on hover.
# Called by powderlink report, which sets: table (rows), curve (model over velocity), output, scripts,
# y_title, diameters (1: of critical diameters over velocity, 0: other kinds over the grains' diameter),
# velocities (how many; rows of one follow each other, a blank line ends them), one_curve (0: rows differ in more than velocity, so that marks stand for the line), n_dem,
# x_low, x_high, y_low, y_high (ranges of the data).
set output output
set datafile separator ","
set ylabel y_title
if (diameters) {
  set xlabel "impact velocity {/:Italic v} (m/s)"
  load scripts . '/log_axes.gp'
} else {
  set xlabel "diameter {/:Italic d} of the grains (µm)"
  # At the right: room for the velocities beside the last marks.
  set xrange [x_low - 0.06 * (x_high - x_low) - 1e-3 : x_high + (velocities > 1 ? 0.17 : 0.06) * (x_high - x_low) + 1e-3]
  set yrange [y_low < 0 ? 1.08 * y_low : -0.04 * y_high : 1.08 * y_high + 1e-6]
}
set key outside above center horizontal maxrows 2 Left reverse width 1
set style fill transparent solid 0.22 noborder
set style textbox noborder
model_plot = one_curve ? \
  "curve using 'velocity_m_s':'low_um':'high_um' with filledcurves linecolor rgb '#009988' title '68 % band', curve using 'velocity_m_s':'diameter_um' with lines linestyle 2 dashtype 1 title 'model', " : \
  "table using 'x':'model' with " . (diameters ? "points" : "linespoints") . " pointtype 1 pointsize 1.6 linewidth 1.6 linecolor rgb '#009988' title 'model', " . \
  (velocities > 1 && !diameters ? "table using 'x':'model':'velocity_label' with labels left offset 1.2,0 font ',15' textcolor rgb '#00776B' notitle, " : "")
dem_plot = n_dem > 0 ? \
  "table using 'x':'dem' with points linestyle 3 pointtype 6 pointsize 1.3 title 'LIGGGHTS', table using 'x':'dem':'dem_hover' with labels hypertext point pointtype 7 pointsize 1.6 linecolor rgb '#FF4477AA' notitle, " : ""
# Bars as arrows with flat heads: gnuplot's error bars blank what lies under their point.
eval "plot " . model_plot . dem_plot . \
  "table using 'x':(column('measured')-column('sigma')):(0):(2*column('sigma')) with vectors heads nofilled size graph 0.011,90 linestyle 4 notitle, " . \
  "table using 'x':'measured' with points linestyle 4 pointtype 7 pointsize 0.7 title 'measured', " . \
  "table using 'x':'measured':'hover' with labels hypertext point pointtype 7 pointsize 1.6 linecolor rgb '#FFEE7733' notitle"
set output
