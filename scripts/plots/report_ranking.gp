# Ranking of explanations: evidence against the study's own model (BIC) and error on rows left out.
# Called by powderlink report, which sets: table, output, rows, widest (of the evidence), most_loo (%).
set terminal svg size 900,(110 + 34 * rows)
set output output
set datafile separator ","
set multiplot
set yrange [rows + 0.6 : 0.4]
set border 1
set tics nomirror
unset ytics
unset key
set style fill solid 0.85 noborder
hidden_bar = "linecolor rgb '#FF000000'"
set bmargin at screen 80.0 / (110 + 34 * rows)
set tmargin at screen 1 - 22.0 / (110 + 34 * rows)
colour(p) = p == 1 ? 0x4477AA : p == 0 ? 0xEE7733 : 0x999999

set lmargin at screen 0.29
set rmargin at screen 0.655
set xlabel "evidence: BIC of the study's model − BIC"
set xrange [(lowest < 0 ? 1.25 * lowest : 0) : widest > 0 ? 1.22 * widest : 1]
set ytics noenhanced scale 0 font ",16"
set for [i=1:rows] ytics add (word(names, i) i)
set arrow 1 from 0, graph 0 to 0, graph 1 nohead linestyle 5
plot table using (0.5*column('evidence')):'row':(abs(0.5*column('evidence'))):(0.32):(colour(column('plausible'))) with boxxyerror linecolor rgb variable, \
  '' using (column('evidence') > 0 ? column('evidence') : 0):'row':(sprintf(" %+.1f", column('evidence'))) with labels left font ",15", \
  '' using (0.5*column('evidence')):'row':'hover' with labels hypertext point pointtype 5 pointsize 2.4 linecolor rgb '#FF000000'
unset arrow 1

set lmargin at screen 0.71
set rmargin at screen 0.985
set xlabel "error on rows left out (%)"
set xrange [0 : 1.3 * most_loo]
unset ytics
plot table using (0.5*column('loo_percent')):'row':(0.5*column('loo_percent')):(0.32):(colour(column('plausible'))) with boxxyerror linecolor rgb variable, \
  '' using 'loo_percent':'row':(sprintf(" %.1f", column('loo_percent'))) with labels left font ",15", \
  '' using (0.5*column('loo_percent')):'row':'hover' with labels hypertext point pointtype 5 pointsize 2.4 linecolor rgb '#FF000000'
unset multiplot
set output
