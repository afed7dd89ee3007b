# Critical diameter against impact velocity: theory, reduced model, DEM with its bracket, measurement.
# Called by plot.sh, which sets: table (kat.csv), output, n_theory, n_reduced, n_dem, n_measured
# n_sigma (rows with a value), x_low, x_high, y_low, y_high (ranges of the data), one_curve (0 when
# the rows differ in adhesive energy, so that no line joins them).
set output output
set datafile separator ","
set logscale xy
set xlabel "impact velocity {/:Italic v} (m/s)"
set ylabel "critical diameter {/:Italic d}_c (µm)"
coarse = "0.01 0.02 0.05 0.1 0.2 0.3 0.5 0.7 1 1.5 2 3 4 5 6 8 10 15 20 30 40 50 60 80 100 150 200 300 500 700 1000"
fine = "0.1 0.12 0.15 0.2 0.25 0.3 0.4 0.5 0.6 0.7 0.8 0.9 1 1.2 1.4 1.6 1.8 2 2.2 2.5 3 3.5 4 4.5 5 5.5 6 6.5 7 8 9 10 12 14 16 18 20 25 30 35 40 45 50 55 60 65 70 80 90 100 120 140 160 180 200 250 300 350 400 450 500 600 700 800 900 1000"
widen = 1.12
set xrange [x_low / widen : x_high * widen]
set yrange [y_low / widen : y_high * widen]
unset mxtics
unset mytics
# Numbers where there is room for them: not closer than a tenth of the axis.
apart(low, high) = exp(0.09 * log(high / low * widen * widen))
set xtics ()
set ytics ()
last = 1e-9
do for [value in (x_high / x_low < 2.2 ? fine : coarse)] {
  if (value > x_low / widen && value < x_high * widen && value > last * apart(x_low, x_high)) {
    set xtics add (value real(value))
    last = real(value)
  }
}
last = 1e-9
do for [value in (y_high / y_low < 2.2 ? fine : coarse)] {
  if (value > y_low / widen && value < y_high * widen && value > last * apart(y_low, y_high)) {
    set ytics add (value real(value))
    last = real(value)
  }
}
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
