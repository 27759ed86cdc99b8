# docs/images/scaling.svg from the tables in docs/scaling.md: gnuplot bench/scaling.gp
load "docs/figures/common.gp"
set terminal svg size 960,440 font "sans,13" background rgb "white"
set output "docs/images/scaling.svg"
set datafile separator "|"
set logscale xy
set format xy "10^{%L}"
set key outside below horizontal
set offsets graph 0.04, graph 0.04, graph 0.04, graph 0.04
# Rows of numbers under a heading.
rows(heading) = "< awk '/^### /{on=index($0,\"".heading."\")} on && /^\\| *[0-9]/' docs/scaling.md"
set multiplot layout 1,3 margins 0.08,0.985,0.3,0.91 spacing 0.07
set ylabel "seconds"
set title "Forward solve"
set xlabel "vertices"
plot rows("Forward") using 2:3 with linespoints lt 1 pt 7 ps 0.5 title "solve", \
     rows("Forward") using 2:4 with linespoints lt 2 pt 7 ps 0.5 title "floor", \
     rows("Forward") using 2:($2*1e-5) with lines lt 7 dt 4 title "linear"
unset ylabel
set title "Design, one rod"
plot rows("trefoil") using 2:3 with linespoints lt 1 pt 7 ps 0.5 title "design", \
     rows("trefoil") using 2:4 with linespoints lt 2 pt 7 ps 0.5 title "floor", \
     rows("trefoil") using 2:(($2/100)) with lines lt 7 dt 4 title "linear"
set title "Design, rods of 50 vertices"
set xlabel "rods"
set format x "%g"
set xtics (1, 2, 5, 10, 20, 50)
plot rows("chain") using 2:3 with linespoints lt 1 pt 7 ps 0.5 title "design", \
     rows("chain") using 2:4 with linespoints lt 2 pt 7 ps 0.5 title "floor", \
     rows("chain") using 2:($2**2) with lines lt 7 dt 4 title "quadratic"
unset multiplot
