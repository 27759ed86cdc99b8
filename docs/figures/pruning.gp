# Inset of section 5.2: springs left after pruning.
set output 'pruning.svg'
set xlabel 'f in the stiffness f E c^2 / L of the first springs'
set ylabel 'springs left' tc lt 1
set y2label 'max error, % of the diagonal' tc lt 2
set logscale xyy2
set format x '10^{%L}'
set format y2 '%g'
set ytics nomirror
set y2tics
set key top center
set arrow 1 from 100, graph 0 to 100, graph 1 nohead lt 6 dt 3
plot 'pruning.csv' using 1:2 with linespoints lt 1 pt 7 ps 0.6 title 'springs', \
     '' using 1:3 axes x1y2 with linespoints lt 2 pt 5 ps 0.6 title 'max error'
