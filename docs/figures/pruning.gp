# Inset of section 5.2: springs left after pruning, and how far from the target.
set output 'pruning.svg'
set multiplot
set logscale xy
set lmargin at screen 0.17
set rmargin at screen 0.97
unset key
set arrow 1 from 100, graph 0 to 100, graph 1 nohead lt 7 dt 4
set label 1 'default' at 100, graph 0.9 offset 0.6,0 tc lt 7
set tmargin at screen 0.96
set bmargin at screen 0.57
set format x ''
set ylabel 'springs left'
plot 'pruning.csv' using 1:2 with linespoints lt 1 pt 7 ps 0.6
unset label 1
set tmargin at screen 0.52
set bmargin at screen 0.14
set format x '10^{%L}'
set format y '%g'
set xlabel 'f in the stiffness f E c^2 / L of the first springs'
set ylabel "max error,\n% of the diagonal"
plot 'pruning.csv' using 1:3 with linespoints lt 2 pt 7 ps 0.6
unset multiplot
