# Mass of particles per length over place and time.
# Called by powderlink flow, which sets: table, output.
set output output
set datafile separator ","
set xlabel "{/:Italic ".axis."} (mm)"
set ylabel "time {/:Italic t} (ms)"
set cblabel "particles (g/m)"
set palette defined (0 "#FFFFFF", 0.25 "#9DB7D5", 0.6 "#4477AA", 1 "#14283F")
set cbrange [0 : *]
set autoscale fix
set tics out nomirror
set rmargin 8.5
plot table using (1e3*column(axis.'_m')):(1e3*column('time_s')):(1e3*column('mass_kg_m')) with image notitle
set output
