# Circularity of every grain over its diameter.
# Called by powderlink psd, which sets: table, output.
set output output
set datafile separator ","
set xlabel "diameter √(4{/:Italic A}/π) (µm)"
set ylabel "circularity 4π{/:Italic A}/{/:Italic P}^2"
set key outside above horizontal Left reverse maxrows 1 width 1
set yrange [* < 0.8 : 1.01]
set offsets graph 0.03, graph 0.03, 0, 0
plot table using (column('area_diameter_um')):(column('speck') == 0 ? column('circularity') : NaN) with points pointtype 7 pointsize 0.45 linecolor rgb attached_colour title "grains", \
  table using (column('area_diameter_um')):(column('speck') == 1 ? column('circularity') : NaN) with points pointtype 4 pointsize 0.7 linecolor rgb detached_colour title "specks"
set output
