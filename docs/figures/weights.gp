# Figure 6: springs and distance against the weight of the sparsity term.
set output 'weights.svg'
set xlabel 'weight of the sparsity term'
set ylabel 'springs' tc lt 1
set y2label 'max error, % of the diagonal' tc lt 2
set logscale x
set format x '10^{%L}'
set ytics nomirror
set y2tics
set yrange [0:*]
set y2range [0:*]
set key top center
plot 'weights.csv' using ($1 > 0 ? $1 : NaN):2 with linespoints lt 1 pt 7 ps 0.6 title 'springs', \
     '' using ($1 > 0 ? $1 : NaN):3 axes x1y2 with linespoints lt 2 pt 5 ps 0.6 title 'max error'
