# Figure 8: the ring leaves its plane, and what that means for a target.
set output 'ring.svg'
set terminal svg size 900,420 font 'sans,13' background rgb 'white'
set multiplot layout 1,2 margins 0.09,0.985,0.27,0.96 spacing 0.12
set xlabel 'length of the cable / diameter of the ring'
set key outside below horizontal
set xrange [0:1]
set ylabel 'smallest side of the box / diameter'
set yrange [-0.01:0.34]
plot 'ring.csv' using 'length':(column('side') > 1e-3 ? column('side') : 0) \
       with lines lt 1 lw 2 title 'stable', \
     '' using 'length':(column('side') > 1e-3 ? 0 : NaN) \
       with lines lt 7 lw 2 dt 2 title 'in the plane, unstable'
set ylabel 'max error, % of the diagonal'
set yrange [0:26]
set label 1 'target T' at 0.2,4.6 center
set label 2 '' at 0.2,0 point lt 2 pt 7 ps 0.7
plot 'ring.csv' using 'length':'free_percent' with lines lt 1 lw 2 title 'stable', \
     '' using 'length':(column('side') > 1e-3 ? column('flat_percent') : NaN) \
       with lines lt 7 lw 2 dt 2 title 'in the plane, unstable'
unset multiplot
