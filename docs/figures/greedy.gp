# Figure 5: as many springs as made the target, found in three ways.
set output 'greedy.svg'
set xlabel 'springs'
set ylabel 'max error, % of the diagonal'
set logscale y
set format y '%g'
set xrange [2.5:13.5]
set xtics 4,2,12
set key outside below horizontal
plot 'knots.csv' using (column('made') + 0.09 * (column('seed') - 5.5)):'greedy_percent' \
       with points lt 7 pt 6 ps 0.6 title 'greedy', \
     '' using (column('made') + 0.09 * (column('seed') - 5.5)):'stiffness_percent' \
       with points lt 2 pt 7 ps 0.5 title 'greedy, stiffnesses fitted', \
     '' using (column('made') + 0.09 * (column('seed') - 5.5)):'global_percent' \
       with points lt 1 pt 7 ps 0.6 title 'global'
