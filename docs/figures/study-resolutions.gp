# gnuplot study-resolutions.gp
set terminal svg size 760,560 font 'sans,13' background rgb 'white'
set border 3 lc rgb '#666666'
set tics nomirror textcolor rgb '#222222'
set grid lc rgb '#e4e4e4' lt 1
set key noenhanced reverse Left samplen 2
set linetype 1 lc rgb '#0060ad'
set linetype 2 lc rgb '#d95319'
set linetype 3 lc rgb '#4f9d2f'
set linetype 4 lc rgb '#7e2f8e'
set linetype 5 lc rgb '#a2842c'
set linetype 6 lc rgb '#008b8b'
set linetype 7 lc rgb '#888888'
set output 'study-resolutions.svg'
data = 'study-resolutions.dat'
set multiplot title 'trefoil-hypotrochoid, a point a resolution' noenhanced
set logscale xy
set format xy '%g'
set autoscale noextend
set offsets graph 0.05, graph 0.05, graph 0.1, graph 0.05
set lmargin at screen 0.12
set rmargin at screen 0.97
set xtics (0.1, 0.2, 0.5, 1, 2, 5, 10, 20, 50, 100, 200, 500)
set tmargin at screen 0.92
set bmargin at screen 0.50
set format x ''
set ylabel 'max error, % of the size' noenhanced
set ytics (0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9, 1, 1.1)
unset key
set label 1 'allowed' at graph 0.01, first 0.8 offset 0,0.5 tc lt 7
plot data index 0 using 1:2 with linespoints lt 1 pt 7 ps 0.45 notitle, \
     data index 1 using 1:2 with linespoints lt 2 pt 7 ps 0.45 notitle, \
     data index 2 using 1:2 with linespoints lt 3 pt 7 ps 0.45 notitle, \
     0.8 with lines lt 7 dt 4 notitle
unset label
set tmargin at screen 0.46
set bmargin at screen 0.22
set format x '%g'
set xlabel 'seconds'
set ylabel 'cables' noenhanced
set ytics (4, 5, 6, 7, 8, 9)
set key at screen 0.5, screen 0.02 center bottom horizontal
plot data index 0 using 1:3 with linespoints lt 1 pt 7 ps 0.45 title 'force-balance, gauss-newton', \
     data index 1 using 1:3 with linespoints lt 2 pt 7 ps 0.45 title 'dense-springs, ipopt', \
     data index 2 using 1:3 with linespoints lt 3 pt 7 ps 0.45 title 'dense-springs, mma'
unset multiplot
