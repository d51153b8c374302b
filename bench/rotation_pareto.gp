# Draws bench/results/rotation-points.csv: gnuplot -e "csv='...'; plots='docs/plots'" rotation_pareto.gp
set terminal svg size 820,600 dynamic font "sans-serif,13" background "white"
set datafile separator ","
set datafile commentschars "#"
set logscale xy
set xlabel "ns for one vector or direction"
set ylabel "largest error of a coefficient"
set format y "10^{%L}"
set yrange [1e-17:1e-4]
set grid xtics ytics lc rgb "#dddddd"
set key inside right center vertical maxcols 1 Left reverse samplen 3   # between float and double
set rmargin 4
array colour[5] = ["#1b6ca8", "#d1495b", "#2e8b57", "#b5651d", "#6a4c93"]
of(what, form, build, column) = strcol("what") eq what && strcol("form") eq form && strcol("build") eq build ? column : NaN

# Peers, if a run with them was kept; blanks in names are underscores here.
float_peers = "awk -F, '$1 == \"peer\" && $3 == \"float\" { gsub(\" \", \"_\", $2); print $2 }' "
names = exists("peers") ? system(float_peers."'".peers."' 2>/dev/null | sort -u") : ""
peer_csv = words(names) ? peers : csv
blanks(s) = strstrt(s, "_") ? s[1:strstrt(s, "_")-1]." ".blanks(s[strstrt(s, "_")+1:*]) : s

set output plots."/rotation_pareto.svg"
array form[5] = ["one shot", "blocks built for one vector", "built blocks on one vector", "built blocks on many vectors", \
                 "built blocks on rows"]
plot for [k=1:5] csv using (of("rotation", form[k], "float", column("ns"))):"error" with linespoints lw 2 pt 7 ps 0.5 \
         lc rgb colour[k] title form[k]." (float)", \
     for [k=1:5] csv using (of("rotation", form[k], "double", column("ns"))):"error" with linespoints lw 2 pt 7 ps 0.5 \
         dashtype 2 lc rgb colour[k] title form[k]." (double)", \
     for [name in names] peer_csv using (of("peer", blanks(name), "float", column("ns"))):"error" with linespoints lw 2 \
         pt 9 ps 0.8 lc rgb "#444444" title blanks(name)." (float)"

set output plots."/ch_pareto.svg"
array form[3] = ["one direction", "many directions", "rows"]
plot for [k=1:3] csv using (of("ch", form[k], "float", column("ns"))):"error" with linespoints lw 2 pt 7 ps 0.5 \
         lc rgb colour[k] title form[k]." (float)", \
     for [k=1:3] csv using (of("ch", form[k], "double", column("ns"))):"error" with linespoints lw 2 pt 7 ps 0.5 \
         dashtype 2 lc rgb colour[k] title form[k]." (double)"
