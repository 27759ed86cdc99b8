# What all figures share; each of them: gnuplot common.gp NAME.gp
set terminal svg size 620,420 font 'sans,13' background rgb 'white'
set datafile separator ','
set datafile missing 'nan'
set grid lc rgb '#dddddd'
set key noenhanced
set linetype 1 lc rgb '#0060ad'
set linetype 2 lc rgb '#d95319'
set linetype 3 lc rgb '#4f9d2f'
set linetype 4 lc rgb '#7e2f8e'
set linetype 5 lc rgb '#a2842c'
set linetype 6 lc rgb '#888888'
