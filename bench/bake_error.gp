# Draws bench/results/bake-error.csv: gnuplot -e "csv='...'; out='...svg'" bake_error.gp
set terminal svg size 800,560 dynamic font "sans-serif,13" background "white"
set output out
set datafile separator ","
set datafile commentschars "#"
set logscale xy
set xlabel "rays a point"
set ylabel "root mean square error of transfer, 2-norm over 5 bands"
set xrange [55:12000]
set yrange [2.5e-4:2]
set grid xtics ytics mxtics mytics lc rgb "#dddddd", lc rgb "#eeeeee"
set key top right reverse Left samplen 2 opaque
set format y "10^{%L}"
set xtics (64, 100, 200, 400, 600, 1000, 2500, 5000, 10000)
stats csv using (column("rays") == 2500 ? column("jittered_sphere") : 1/0) nooutput
level = STATS_mean
set arrow 1 from 55, level to 2500, level nohead dashtype 2 lc rgb "#888888"
set arrow 2 from 600, graph 0 to 600, graph 1 nohead dashtype 3 lc rgb "#888888"
set label 1 sprintf("Chapter's 2500 samples: %.4f", level) at 60, level*0.55 left textcolor rgb "#555555"
plot csv using "rays":"random_cosine" with linespoints lw 1.5 pt 2 ps 0.6 lc rgb "#999999" \
     title "independent, cosine", \
     csv using "rays":"jittered_sphere" with linespoints lw 2.0 pt 7 ps 0.6 lc rgb "#d1495b" \
     title "jittered grid on the sphere (Chapter 2010)", \
     csv using "rays":"jittered_cosine" with linespoints lw 1.5 pt 5 ps 0.6 lc rgb "#b5651d" \
     title "jittered grid, cosine", \
     csv using "rays":"sobol_cosine" with linespoints lw 1.5 pt 9 ps 0.6 lc rgb "#6a4c93" \
     title "Sobol, Owen scrambled, cosine", \
     csv using "rays":"fibonacci_hemisphere" with linespoints lw 1.5 pt 11 ps 0.6 lc rgb "#2e8b57" \
     title "Fibonacci, uniform hemisphere", \
     csv using "rays":"fibonacci_cosine" with linespoints lw 2.5 pt 7 ps 0.6 lc rgb "#1b6ca8" \
     title "Fibonacci, cosine (prt\\_bake\\_transfer)"
