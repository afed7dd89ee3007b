# Terms of the balance of forces, as pressures over the section: those of the gas above those of the powder.
# Called by powderlink flow, which sets: table, output.
set output output
set datafile separator ","
set xlabel "force over the section (Pa)"
set key off
set ytics nomirror scale 0
set yrange [-11.6 : 0.6] noextend
set grid xtics linecolor rgb "#DDDDDD" linewidth 0.6
set arrow 1 from 0, graph 0 to 0, graph 1 nohead linestyle 5
set arrow 2 from graph 0, first -4.5 to graph 1, first -4.5 nohead linecolor rgb "#AAAAAA" linewidth 0.8
set offsets graph 0.03, graph 0.12, 0, 0
bar = 0.32
colour(balance) = balance eq "gas" ? 0x4477AA : 0xEE7733
plot table using 'pressure_Pa':(-$0):(0):'pressure_Pa':(-$0-bar):(-$0+bar):(colour(strcol('balance'))):yticlabels(strcol('balance').": ".strcol('term')) with boxxyerror linecolor rgb variable fillstyle solid 0.75 noborder, \
  table using (column('pressure_Pa') > 0 ? column('pressure_Pa') : 0):(-$0):(sprintf("%.0f", column('pressure_Pa'))) with labels left offset 0.6,0
set output
