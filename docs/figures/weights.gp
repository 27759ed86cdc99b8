# Figure 6: springs and distance against the weight of the sparsity term.
set output 'weights.svg'
set multiplot
set logscale x
set lmargin at screen 0.17
set rmargin at screen 0.97
set yrange [0:*]
unset key
set tmargin at screen 0.96
set bmargin at screen 0.57
set format x ''
set ylabel 'springs'
plot 'weights.csv' using ($1 > 0 ? $1 : NaN):2 with linespoints lt 1 pt 7 ps 0.6
set tmargin at screen 0.52
set bmargin at screen 0.14
set format x '10^{%L}'
set xlabel 'weight of the sparsity term'
set ylabel "max error,\n% of the diagonal"
plot 'weights.csv' using ($1 > 0 ? $1 : NaN):3 with linespoints lt 2 pt 7 ps 0.6
unset multiplot
