# Draws bench/results/rotation-error.csv: gnuplot -e "csv='...'; out='...svg'" rotation_error.gp
set terminal svg size 800,560 dynamic font "sans-serif,13" background "white"
set output out
set datafile separator ","
set datafile commentschars "#"
set logscale y
set xlabel "band l"
set ylabel "largest entry of |M M^T - 1|"
set xrange [0:128]
set yrange [1e-17:1e10]
set xtics 16
set format y "10^{%L}"
set grid xtics ytics lc rgb "#dddddd"
set key top left Left reverse samplen 2 opaque
plot csv using "l":"published_float" with lines lw 2 lc rgb "#d1495b" title "as published, float", \
     csv using "l":"published_double" with lines lw 2 dashtype 2 lc rgb "#d1495b" title "as published, double", \
     csv using "l":"prt_float" with lines lw 2.5 lc rgb "#1b6ca8" title "prt.h, float", \
     csv using "l":"prt_double" with lines lw 2.5 dashtype 2 lc rgb "#1b6ca8" title "prt.h, double"
