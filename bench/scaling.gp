# docs/images/scaling.svg from the tables in docs/scaling.md: gnuplot bench/scaling.gp
set terminal svg size 960,420 font "sans,12" background "white"
set output "docs/images/scaling.svg"
set datafile separator "|"
set logscale xy
set format y "10^{%L}"
set key left top samplen 2
set grid xtics ytics lc rgb "#dddddd"
# Rows of numbers under a heading.
rows(heading) = "< awk '/^### /{on=index($0,\"".heading."\")} on && /^\\| *[0-9]/' docs/scaling.md"
set multiplot layout 1,3
set ylabel "seconds"
set title "Forward solve"
set xlabel "vertices"
plot rows("Forward") using 2:3 with linespoints lw 2 pt 7 ps 0.5 title "solve", \
     rows("Forward") using 2:4 with linespoints lw 2 pt 6 ps 0.5 dt 2 title "floor", \
     rows("Forward") using 2:($2*1e-5) with lines lc rgb "#999999" dt 3 title "linear"
unset ylabel
set title "Design, one rod"
plot rows("trefoil") using 2:3 with linespoints lw 2 pt 7 ps 0.5 title "design", \
     rows("trefoil") using 2:4 with linespoints lw 2 pt 6 ps 0.5 dt 2 title "floor", \
     rows("trefoil") using 2:(($2/100)) with lines lc rgb "#999999" dt 3 title "linear"
set title "Design, rods of 50 vertices"
set xlabel "rods"
plot rows("chain") using 2:3 with linespoints lw 2 pt 7 ps 0.5 title "design", \
     rows("chain") using 2:4 with linespoints lw 2 pt 6 ps 0.5 dt 2 title "floor", \
     rows("chain") using 2:($2**2) with lines lc rgb "#999999" dt 3 title "quadratic"
unset multiplot
