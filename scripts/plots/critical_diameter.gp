# Critical diameter against impact velocity: theory, reduced model, DEM with its bracket, measurement.
# Called by plot.sh, which sets: table (kat.csv), output, scripts (this folder), n_theory, n_reduced, n_dem, n_measured
# n_sigma (rows with a value), x_low, x_high, y_low, y_high (ranges of the data), one_curve (0 when
# the rows differ in adhesive energy, so that no line joins them).
set output output
set datafile separator ","
set xlabel "impact velocity {/:Italic v} (m/s)"
set ylabel "critical diameter {/:Italic d}_c (µm)"
load scripts . '/log_axes.gp'
# Above the plot: covers no data, whatever they are.
set key outside above center horizontal maxcols 2 Left reverse width 2
bracket_low(a, b) = a < b ? a : b
bracket_high(a, b) = a < b ? b : a
# A curve needs two rows of one adhesive energy; else each row is a mark.
theory_style = n_theory > 1 && one_curve ? "smooth unique with lines linestyle 1" : "with points pointtype 2 pointsize 2.0 linewidth 2 linecolor rgb ink"
reduced_style = n_reduced > 1 && one_curve ? "smooth unique with lines linestyle 2" : "with points pointtype 1 pointsize 2.2 linewidth 2 linecolor rgb \"#009988\""
command = ""
if (n_theory > 0) { command = command . "table using 'impact_velocity_m_s':'theory_um' " . theory_style . " title 'closed form', " }
if (n_reduced > 0) { command = command . "table using 'impact_velocity_m_s':'reduced_um' " . reduced_style . " title 'reduced model', " }
# Bars as arrows with flat heads: gnuplot's error bars blank what lies under their point.
if (n_measured > 0 && n_sigma > 0) { command = command . "table using (column('impact_velocity_m_s')):(column('measured_um')-column('measured_sigma_um')):(0):(2*column('measured_sigma_um')) with vectors heads nofilled size graph 0.009,90 linestyle 4 notitle, " }
if (n_measured > 0) { command = command . "table using 'impact_velocity_m_s':'measured_um' with points linestyle 4 title 'measured', " }
if (n_dem > 0) { command = command . "table using (column('impact_velocity_m_s')):(column('critical_diameter_um')):(bracket_low(column('largest_attached_um'),column('smallest_detached_um'))):(bracket_high(column('largest_attached_um'),column('smallest_detached_um'))) with yerrorbars linestyle 3 title 'DEM, bracketing sizes', " }
eval "plot " . command[1:strlen(command) - 2]
set output
