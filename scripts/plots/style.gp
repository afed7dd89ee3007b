# Look of all figures: one column of a journal wide, colours for any colour vision and for grey print.
# The same colours are in analysis/render/palette.h and scripts/paraview/kat_view.py.
set encoding utf8
# A figure of another size says `set terminal svg size WIDTH,HEIGHT @look`: size alone would reset the rest.
look = "enhanced font 'Helvetica,Arial,DejaVu Sans,sans-serif,17' background '#FFFFFF' linewidth 1.4"
set terminal svg size 720,540 @look
set border 31 linewidth 1.0 linecolor rgb "#1A1A1A"
set tics in scale 0.9,0.5 textcolor rgb "#1A1A1A"
set format "%g"
attached_colour = "#4477AA"
detached_colour = "#EE7733"
ink = "#1A1A1A"
set style line 1 linecolor rgb ink linewidth 2.0 dashtype 1                            # theory
set style line 2 linecolor rgb "#009988" linewidth 2.0 dashtype (10,5)                 # reduced model
set style line 3 linecolor rgb attached_colour linewidth 1.8 pointtype 7 pointsize 0.8 # DEM
set style line 4 linecolor rgb detached_colour linewidth 2.0 pointtype 4 pointsize 1.2 # measured
set style line 5 linecolor rgb "#777777" linewidth 1.2 dashtype (3,4)                  # guides
set key samplen 2.2 spacing 1.25 width -1 nobox
# Step of at most six numbers on an axis: more would touch.
round_step(s) = s <= 1 ? 1 : s <= 2 ? 2 : s <= 5 ? 5 : 10
decade(s) = 10**floor(log10(s))
tic_step(low, high) = decade((high - low) / 5.0) * round_step((high - low) / 5.0 / decade((high - low) / 5.0))
