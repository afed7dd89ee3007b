# Ranking of explanations: evidence against the study's own model (BIC) and error on rows left out.
# Called by powderlink report, which sets: table, output, rows, names (separated by
# blanks), lowest and widest (of the evidence), most_loo (of what is left out, in unit).
set terminal svg size 900,(170 + 34 * rows) @look
set output output
set datafile separator ","
set multiplot
set yrange [rows + 0.6 : 0.4]
set border 1
set tics nomirror
set key at screen 0.985, screen 0.985 top right vertical reverse Left samplen 1.5 width -2
unset ytics
colour_of(p) = p == 1 ? 0x4477AA : p == 0 ? 0xEE7733 : 0x999999
# Values that are not possible are pale with an outline: told apart in grey print too.
# Zero has no sign.
signed(x) = abs(x) < 0.05 ? "0.0" : sprintf("%+.1f", x)
filled = "solid 0.9 noborder"
pale = "transparent solid 0.25 border linecolor rgb '#EE7733'"
set bmargin at screen 80.0 / (170 + 34 * rows)
set tmargin at screen 1 - 82.0 / (170 + 34 * rows)

set lmargin at screen 0.29
set rmargin at screen 0.655
set xlabel "evidence: BIC of the study's model − BIC" font ",16"
set xtics font ",15" tic_step(lowest < 0 ? lowest : 0, widest > 0 ? widest : 1)
set xrange [(lowest < 0 ? 1.25 * lowest : 0) : widest > 0 ? 1.22 * widest : 1]
set ytics noenhanced scale 0 font ",16" ()
set for [i=1:rows] ytics add (word(names, i) i)
set arrow 1 from 0, graph 0 to 0, graph 1 nohead linestyle 5
plot table using (column('plausible') != 0 ? 0.5*column('evidence') : NaN):'row':(abs(0.5*column('evidence'))):(0.32):(colour_of(column('plausible'))) with boxxyerror fillstyle @filled linecolor rgb variable notitle, \
  '' using (column('plausible') == 0 ? 0.5*column('evidence') : NaN):'row':(abs(0.5*column('evidence'))):(0.32) with boxxyerror fillcolor rgb "#EE7733" fillstyle @pale notitle, \
  '' using (column('evidence') > 0 ? column('evidence') : 0):'row':(signed(column('evidence'))) with labels left offset 0.5,0 font ",15" notitle, \
  for [k=1:9:2] '' using (0.1*k*column('evidence')):'row':'hover' with labels hypertext point pointtype 5 pointsize 1.8 linecolor rgb '#FF000000' notitle, \
  keyentry with boxes fillstyle @filled linecolor rgb "#4477AA" title "possible values", \
  keyentry with boxes fillcolor rgb "#EE7733" fillstyle @pale title "values that are not possible"
unset key
unset arrow 1

set lmargin at screen 0.71
set rmargin at screen 0.985
set xlabel "error on rows left out (".unit.")" font ",16"
set xtics tic_step(0, most_loo)
set xrange [0 : 1.3 * most_loo]
unset ytics
plot table using (column('plausible') != 0 ? 0.5*column('loo_percent') : NaN):'row':(abs(0.5*column('loo_percent'))):(0.32):(colour_of(column('plausible'))) with boxxyerror fillstyle @filled linecolor rgb variable notitle, \
  '' using (column('plausible') == 0 ? 0.5*column('loo_percent') : NaN):'row':(abs(0.5*column('loo_percent'))):(0.32) with boxxyerror fillcolor rgb "#EE7733" fillstyle @pale notitle, \
  '' using 'loo_percent':'row':(sprintf("%.1f", column('loo_percent'))) with labels left offset 0.5,0 font ",15" notitle, \
  for [k=1:9:2] '' using (0.1*k*column('loo_percent')):'row':'hover' with labels hypertext point pointtype 5 pointsize 1.8 linecolor rgb '#FF000000' notitle
unset multiplot
set output
