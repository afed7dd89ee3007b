# Error of the model before and after each added effect.
# Called by powderlink report, which sets: table, output, studies, names (separated by blanks),
# n_dem, noise (%, 0: unknown), most (largest error, %).
set output output
set datafile separator ","
set ylabel "rms relative error (%)"
set xrange [0.4 : studies + 0.6]
set yrange [0 : 1.18 * most]
set style fill solid 0.85 noborder
set border 3
set tics nomirror
set xtics noenhanced scale 0 ()
set for [i=1:studies] xtics add (word(names, i) i)
set key outside above center horizontal Left reverse
half = n_dem > 0 ? 0.19 : 0.0
wide = n_dem > 0 ? 0.36 : 0.5
set boxwidth wide
if (noise > 0) { set arrow 1 from graph 0, first noise to graph 1, first noise nohead linestyle 5 front }
noise_plot = noise > 0 ? ", NaN with lines linestyle 5 title 'noise of one drop'" : ""
dem_plot = n_dem > 0 ? \
  ", table using (column('study')+half):'dem_percent' with boxes linecolor rgb '#4477AA' title 'LIGGGHTS', '' using (column('study')+half):'dem_percent':(sprintf('%.1f', column('dem_percent'))) with labels offset 0,0.7 font ',15' notitle, for [k=1:9:2] '' using (column('study')+half):(0.1*k*column('dem_percent')):'dem_hover' with labels hypertext point pointtype 5 pointsize 3 linecolor rgb '#FF000000' notitle" : ""
eval "plot table using (column('study')-half):'reduced_percent' with boxes linecolor rgb '#009988' title 'reduced model', " . \
  "'' using (column('study')-half):'reduced_percent':(sprintf('%.1f', column('reduced_percent'))) with labels offset 0,0.7 font ',15' notitle, " . \
  "for [k=1:9:2] '' using (column('study')-half):(0.1*k*column('reduced_percent')):'hover' with labels hypertext point pointtype 5 pointsize 3 linecolor rgb '#FF000000' notitle" . dem_plot . noise_plot
set output
