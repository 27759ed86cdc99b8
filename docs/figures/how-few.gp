# Cables that were found within an error, and cables that are needed at least.
set output 'how-few.svg'
set logscale x
set xlabel 'max error, % of the size'
set ylabel 'cables'
set yrange [0:26]
set format x '%g'
of(name) = "< grep -e ^knot -e ^".name." how-few.csv | sort -t, -k3,3g"
plot of('3_1') using 'max_percent':'cables' with points lt 1 pt 7 ps 0.7 title 'found, 3_1', \
     '' using 'max_percent':'at_least' with fsteps lt 1 lw 2 title 'at least, 3_1', \
     of('4_1') using 'max_percent':'cables' with points lt 2 pt 7 ps 0.7 title 'found, 4_1', \
     '' using 'max_percent':'at_least' with fsteps lt 2 lw 2 dt 2 title 'at least, 4_1'
