# Four quantities of the pipe by what was moved, with their intervals, and what the source prints (dashed).
# Called by sensitivity.sh, which sets: table (name, then value and half an interval of each), output, rows,
# names, printed, lowest, highest (four values each, NaN for none; the last two with intervals and what is printed).
set terminal svg size 1200,(150 + 34*rows) @look
set output output
set multiplot layout 1,4 margins 0.105,0.985,90.0/(150 + 34*rows),1 - 20.0/(150 + 34*rows) spacing 0.025
set yrange [rows + 0.6 : 0.4]
set tics nomirror
set grid xtics
unset key
set xtics font ",14"
set ytics noenhanced scale 0 font ",15" ()
set for [k=1:rows] ytics add (word(names, k) k)
array titles[4] = ["grains (10^3)", "velocity (m/s)", "slope (kPa/m)", "rms of the flow (%)"]
array unit[4] = [1e-3, 1, 1e-3, 1]
do for [k=1:4] {
  set xlabel titles[k]
  unset arrow
  if (word(printed, k) ne "NaN") {
    at = unit[k]*real(word(printed, k))
    set arrow 1 from at, graph 0 to at, graph 1 nohead linestyle 5
  }
  if (word(lowest, k) ne "NaN") {
    low = unit[k]*real(word(lowest, k))
    high = unit[k]*real(word(highest, k))
    margin = high > low ? 0.06*(high - low) : 0.06*high
    set xrange [low - margin : high + margin]
    set xtics tic_step(low - margin, high + margin)
  } else {
    set xrange [0:1]
  }
  scale = unit[k]
  plot table using (scale*column(2*k)):(column(0) + 1):(scale*column(2*k + 1)) with xerrorbars linestyle 3
  unset ytics
}
unset multiplot
set output
