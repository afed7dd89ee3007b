# Velocity of the particles along the pipe: mean and standard deviation.
# Called by powderlink flow, which sets: table, output.
set output output
set datafile separator ","
set xlabel "{/:Italic ".axis."} (mm)"
set ylabel "particle velocity {/:Italic v}_".axis." (m/s)"
set key outside above horizontal Left reverse maxrows 1 width 1
set autoscale xfix
# The spread of a handful of particles says nothing.
shown(value, count) = count >= enough ? value : NaN
plot table using (1e3*column(axis.'_m')):(shown(column('velocity_mean_m_s')-column('velocity_std_m_s'),column('count'))):(shown(column('velocity_mean_m_s')+column('velocity_std_m_s'),column('count'))) with filledcurves linecolor rgb "#D6E0EC" title "± standard deviation", \
  table using (1e3*column(axis.'_m')):(shown(column('velocity_mean_m_s'),column('count'))) with lines linestyle 1 title "mean"
set output
