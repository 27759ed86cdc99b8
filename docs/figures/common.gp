# What all figures share; each of them: gnuplot common.gp NAME.gp
set terminal svg size 620,420 font 'sans,13' background rgb 'white'
set datafile separator ','
set datafile missing 'nan'
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
# What is allowed or taken, and other lines to compare with.
set linetype 7 lc rgb '#888888'
