# Terms of the balance of forces, as pressures over the section: those of the gas above those of the powder.
# Called by powderlink flow, which sets: table, output.
set output output
set datafile separator ","
set xlabel "force over the section (Pa)"
set key off
set ytics nomirror scale 0
stats table using 'pressure_Pa' nooutput
low = STATS_min < 0 ? 1.1*STATS_min : -0.05*STATS_max
high = 1.18*STATS_max
set xrange [low : high]
set xtics tic_step(low, high)
set yrange [-10.7 : 0.7] noextend
set terminal svg size 900,480 @look
set grid xtics linecolor rgb "#DDDDDD" linewidth 0.6
set arrow 1 from 0, graph 0 to 0, graph 1 nohead linestyle 5
set arrow 2 from graph 0, first -4.5 to graph 1, first -4.5 nohead linecolor rgb "#AAAAAA" linewidth 0.8
bar = 0.32
shown(value) = abs(value) < 10 ? sprintf("%.1f", value) : sprintf("%.0f", value)
colour(balance) = balance eq "gas" ? 0x4477AA : 0xEE7733
plot table using 'pressure_Pa':(-$0):(0):'pressure_Pa':(-$0-bar):(-$0+bar):(colour(strcol('balance'))):yticlabels(strcol('balance').": ".strcol('term')) with boxxyerror linecolor rgb variable fillstyle solid 0.75 noborder, \
  table using (column('pressure_Pa') > 0 ? column('pressure_Pa') : 0):(-$0):(shown(column('pressure_Pa'))) with labels left offset 0.6,0
set output
