# Share of the powder per class of diameter, by number and by mass.
# Called by powderlink psd, which sets: table, output, d50_number, d50_mass.
set output output
set datafile separator ","
set xlabel "diameter {/:Italic d} (µm)"
set ylabel "share per class (%)"
set key outside above horizontal Left reverse maxrows 1 width 1
set yrange [0 : *]
set style fill solid 0.55 noborder
plot table using (0.5*(column('low_um')+column('high_um'))):(100*column('share_number')):(column('high_um')-column('low_um')) with boxes linecolor rgb attached_colour title sprintf("by number, median %.3g µm", d50_number), \
  table using (column('low_um')):(100*column('share_mass')) with fsteps linewidth 2.2 linecolor rgb detached_colour title sprintf("by mass, median %.3g µm", d50_mass)
set output
