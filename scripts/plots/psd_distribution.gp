# Share of the powder finer than d, by number and by mass, with the fitted Rosin-Rammler laws.
# Called by powderlink psd, which sets: table, output, grains, and per weighting (number, mass)
# NAME_x0 (um, -1: no law), NAME_n, NAME_r2, d50_NAME.
set output output
set datafile separator ","
set xlabel "diameter {/:Italic d} (µm)"
set ylabel "share finer than {/:Italic d}"
set yrange [0 : 1.001]
set key outside above horizontal Left reverse maxrows 2 width -4
law(d, x0, n) = 1 - exp(-(d/x0)**n)
set samples 400
range = largest - smallest
set xrange [(smallest > 0.08*range ? smallest - 0.08*range : 0) : largest + 0.08*range]
fitted(name, x0, n, r2) = sprintf("{/:Italic x}_0 %.3g µm, {/:Italic n} %.3g, {/:Italic R}^2 %.4f", x0, n, r2)
set arrow 1 from graph 0, first 0.5 to graph 1, first 0.5 nohead linestyle 5
plot table using (column('diameter_um')):(column('finer_number')) with steps linewidth 2.2 linecolor rgb attached_colour title sprintf("by number, %d grains", grains), \
  number_x0 > 0 ? law(x, number_x0, number_n) : NaN with lines linewidth 1.6 dashtype (10,5) linecolor rgb ink title number_x0 > 0 ? fitted("number", number_x0, number_n, number_r2) : "", \
  table using (column('diameter_um')):(column('finer_mass')) with steps linewidth 2.2 linecolor rgb detached_colour title "by mass", \
  mass_x0 > 0 ? law(x, mass_x0, mass_n) : NaN with lines linewidth 1.6 dashtype (3,4) linecolor rgb ink title mass_x0 > 0 ? fitted("mass", mass_x0, mass_n, mass_r2) : ""
set output
