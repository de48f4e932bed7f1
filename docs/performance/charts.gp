# Draws roofline, scaling and stages, .svg and .png each, in the folder of scenes.csv and
# scaling.csv: gnuplot ../charts.gp
set datafile separator ","

colour(i) = word("#0072b2 #d55e00 #009e73 #cc79a7 #e69f00 #56b4e9 #000000 #7f7f7f", (i - 1) % 8 + 1)
symbol(i) = int(word("7 5 9 11 13 15 6 4", (i - 1) % 8 + 1))
names(csv) = system("awk -F, 'NR > 1 && !seen[$1]++ { print $1 }' " . csv)
first(column) = real(system(sprintf("awk -F, 'NR == 2 { print $%d }' scenes.csv", column)))
most_threads = int(system("awk -F, 'NR > 1 && $2 > m { m = $2 } END { print m }' scenes.csv"))

scenes = names("scenes.csv")
scales = names("scaling.csv")
fma = first(5)
write = first(6)

terminal(kind, width, height) = sprintf(kind eq "svg" \
  ? "set terminal svg size %d, %d font 'DejaVu Sans,12' background 'white'" \
  : "set terminal pngcairo size %d, %d font 'DejaVu Sans,9' background 'white'", width, height)

set grid back linecolor rgb "#e4e4e4" linetype 1

# ---- roofline: what the machine allows, and where the scenes are ----
roof(x) = x * write < fma ? x * write : fma
one_thread(scene) = "< awk -F, -v s=" . scene . " '$1 == s && $2 == 1' scenes.csv"
do for [kind in "svg png"] {
  eval terminal(kind, 760, 440)
  set output "roofline." . kind
  set logscale xy
  set xlabel "operations to shade, a byte of mesh and picture"
  set ylabel "GFLOP/s"
  set xrange [0.1 : 1000]
  set yrange [fma / 1000 : 2 * fma]
  set format "%g"
  set key outside right center Left reverse samplen 1
  set label 1 sprintf("multiply-adds, %.0f GFLOP/s", fma) at 900, 1.2 * fma right
  set label 2 sprintf("writing,\n%.0f GB/s", write) at 0.5, 0.9 * write right
  plot [x = 0.1 : 1000] roof(x) with lines linewidth 2 linecolor rgb "#555555" notitle, \
    for [i = 1:words(scenes)] one_thread(word(scenes, i)) using 3:4 with points pointsize 1.2 \
      pointtype symbol(i) linecolor rgb colour(i) title word(scenes, i)
}
unset label

# ---- scaling: a panel a scale, measured and fitted ----
points(scale) = "< awk -F, -v s=" . scale . " '$1 == s' scaling.csv"
slope(scale) = system("awk -F, -v s=" . scale . " '$1 == s { print $5; exit }' scaling.csv")
rows = (words(scales) + 1) / 2
do for [kind in "svg png"] {
  eval terminal(kind, 960, 300 * rows)
  set output "scaling." . kind
  set multiplot layout rows, 2
  set lmargin 9
  set ylabel "ms" offset 1, 0
  set format y "%g"
  unset key
  do for [scale in scales] {
    few = scale eq "lanes" || scale eq "threads"
    set xlabel scale offset 0, 0.4
    set format x (few ? "%g" : "10^{%T}")
    if (few) { set xtics (1, 2, 4, 8, 16, 32) } else { set xtics auto }
    set ytics auto
    set for [k = -3:5] for [digit in "2 5"] ytics add (digit * 10.0 ** k)
    unset logscale
    set autoscale
    stats points(scale) using 2 name "X" nooutput
    stats points(scale) using 3 name "Y" nooutput
    set logscale xy
    set xrange [X_min / 1.3 : X_max * 1.3]
    set yrange [Y_min / 1.6 : Y_max * 1.6]
    set title scale . ": slope " . slope(scale) font ",12" offset 0, -0.6
    plot points(scale) using 2:4 with lines dashtype 2 linecolor rgb "#999999", \
      points(scale) using 2:3 with linespoints pointtype 7 pointsize 0.8 linecolor rgb colour(1)
  }
  unset multiplot
}
unset logscale
set lmargin

# ---- stages: how a frame spends its time ----
stages = "geometry visibility shading output"
threads(n) = sprintf("< awk -F, '$2 == %d' scenes.csv", n)
panels = most_threads > 1 ? 2 : 1
do for [kind in "svg png"] {
  eval terminal(kind, 960, 300 * panels + 40)
  set output "stages." . kind
  set multiplot layout panels, 1
  set style data histograms
  set style histogram rowstacked
  set style fill solid 0.9 border rgb "white"
  set boxwidth 0.7
  set xlabel ""
  set ylabel "share of the frame, %" offset 1, 0
  set yrange [0:112]
  set xrange [-0.6 : words(scenes) - 0.4]
  set xtics auto
  set ytics 0, 20, 100
  set format "%g"
  set key outside right center Left reverse invert samplen 1
  do for [panel = 1:panels] {
    n = panel == 1 ? 1 : most_threads
    set title sprintf(n == 1 ? "%d thread" : "%d threads", n) font ",12" offset 0, -0.6
    plot for [i = 1:4] threads(n) using (100 * column(i + 6) / $11):xtic(1) \
        linecolor rgb colour(i) title word(stages, i), \
      threads(n) using (100 - 100 * ($7 + $8 + $9 + $10) / $11) linecolor rgb "#bbbbbb" \
        title "other, waiting", \
      threads(n) using 0:(105):(sprintf("%.3g ms", $11)) with labels font ",10" notitle
  }
  unset multiplot
}
