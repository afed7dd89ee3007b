# Measured critical diameters with error bars against the model of a study: curve, band of its fit,
# DEM where it was run. Values on hover.
# Called by powderlink report, which sets: table (rows), curve (model over velocity), output, scripts,
# one_curve (0: rows differ in more than velocity, so that marks stand for the line), n_dem,
# x_low, x_high, y_low, y_high (ranges of the data).
set output output
set datafile separator ","
set xlabel "impact velocity {/:Italic v} (m/s)"
set ylabel "critical diameter {/:Italic d}_c (µm)"
load scripts . '/log_axes.gp'
set key outside above center horizontal maxrows 2 Left reverse width 1
set style fill transparent solid 0.22 noborder
set style textbox noborder
model_plot = one_curve ? \
  "curve using 'velocity_m_s':'low_um':'high_um' with filledcurves linecolor rgb '#009988' title 'band of the fit (68 %)', curve using 'velocity_m_s':'diameter_um' with lines linestyle 2 dashtype 1 title 'model', " : \
  "table using 'impact_velocity_m_s':'model_um' with points pointtype 1 pointsize 2.2 linewidth 2 linecolor rgb '#009988' title 'model', "
dem_plot = n_dem > 0 ? \
  "table using 'impact_velocity_m_s':'dem_um' with points linestyle 3 pointtype 6 pointsize 1.3 title 'LIGGGHTS', table using 'impact_velocity_m_s':'dem_um':'dem_hover' with labels hypertext point pointtype 7 pointsize 1.6 linecolor rgb '#FF4477AA' notitle, " : ""
# Bars as arrows with flat heads: gnuplot's error bars blank what lies under their point.
eval "plot " . model_plot . dem_plot . \
  "table using 'impact_velocity_m_s':(column('measured_um')-column('sigma_um')):(0):(2*column('sigma_um')) with vectors heads nofilled size graph 0.011,90 linestyle 4 notitle, " . \
  "table using 'impact_velocity_m_s':'measured_um' with points linestyle 4 pointtype 7 pointsize 0.7 title 'measured', " . \
  "table using 'impact_velocity_m_s':'measured_um':'hover' with labels hypertext point pointtype 7 pointsize 1.6 linecolor rgb '#FFEE7733' notitle"
set output
