# Logarithmic axes around the data, with numbers at round values where there is room for them.
# Loaded by figures; needs x_low, x_high, y_low, y_high (ranges of the data).
set logscale xy
coarse = "0.01 0.02 0.05 0.1 0.2 0.3 0.5 0.7 1 1.5 2 3 4 5 6 8 10 15 20 30 40 50 60 80 100 150 200 300 500 700 1000"
fine = "0.1 0.12 0.15 0.2 0.25 0.3 0.4 0.5 0.6 0.7 0.8 0.9 1 1.2 1.4 1.6 1.8 2 2.2 2.5 3 3.5 4 4.5 5 5.5 6 6.5 7 8 9 10 12 14 16 18 20 25 30 35 40 45 50 55 60 65 70 80 90 100 120 140 160 180 200 250 300 350 400 450 500 600 700 800 900 1000"
widen = 1.12
set xrange [x_low / widen : x_high * widen]
set yrange [y_low / widen : y_high * widen]
unset mxtics
unset mytics
# Numbers where there is room for them: not closer than a tenth of the axis.
apart(low, high) = exp(0.09 * log(high / low * widen * widen))
set xtics ()
set ytics ()
last = 1e-9
do for [value in (x_high / x_low < 2.2 ? fine : coarse)] {
  if (value > x_low / widen && value < x_high * widen && value > last * apart(x_low, x_high)) {
    set xtics add (value real(value))
    last = real(value)
  }
}
last = 1e-9
do for [value in (y_high / y_low < 2.2 ? fine : coarse)] {
  if (value > y_low / widen && value < y_high * widen && value > last * apart(y_low, y_high)) {
    set ytics add (value real(value))
    last = real(value)
  }
}
