# Figure 14: cables found for random closed rods, and how many made them.
set output 'knots.svg'
set xlabel 'max error, % of the diagonal'
set ylabel 'cables'
set xrange [0:1.1]
set yrange [0:13]
set ytics 2
set key outside right
set for [i=1:5] arrow i from graph 0, first 2 + 2 * i to graph 1, first 2 + 2 * i nohead lt i dt 2
set arrow 6 from 1, graph 0 to 1, graph 1 nohead lt 7 dt 4
set label 1 'allowed' at 1, graph 0.03 right offset -0.5,0 tc lt 7
plot for [i=1:5] 'knots.csv' using (column('made') == 2 + 2 * i ? column('max_percent') : NaN): \
       (column('found') + 0.12 * (i - 3)) with points lt i pt 7 ps 0.6 \
       title sprintf('made with %d', 2 + 2 * i)
