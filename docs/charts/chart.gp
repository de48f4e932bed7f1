# Draws a family's chart: gnuplot -e "csv='FAMILY.csv'; stem='FAMILY'" chart.gp
# writes stem.svg and stem.png: a panel a task, cost against error, the front as a line with names.
set datafile separator ","

# The i-th of the different values of a column, and how many there are.
unique(what) = "awk -F, 'NR > 1 { print " . what . " }' " . csv . " | awk '!seen[$0]++'"
count(what) = int(system(unique(what) . " | wc -l"))
nth(what, i) = system(unique(what) . sprintf(" | sed -n %dp", i))
task_of_line = '$2 ", " $9'
tasks = count(task_of_line)
methods = count("$1")
array name[methods]
array shade[methods]
do for [i = 1:methods] { name[i] = nth("$1", i) }
per = nth("$3", 1)
judged = nth("$10", 1)
error = judged eq "max" ? 7 : 8

# The lines of a task; those on the front, by cost, and last where their names stand: below each
# other, never nearer than step.
lines(t) = "awk -F, -v t='" . t . "' 'NR > 1 && " . task_of_line . " == t' " . csv
front(t, step) = lines(t) . sprintf(" | awk -F, '$11 == 1' | sort -t, -k4,4g | awk -F, ". \
  "'{ e = $%d == 0 ? %g : $%d; y = NR > 1 && y / %g < e ? y / %g : e; print $0 \",\" y }'", \
  error, floor_at, error, step, step)

colour(i) = word("#0072b2 #d55e00 #009e73 #cc79a7 #e69f00 #56b4e9 #000000 #7f7f7f " . \
  "#8c564b #9467bd #17becf #bcbd22 #e377c2 #1b9e77 #666666 #a6761d", (i - 1) % 16 + 1)
symbol(i) = int(word("7 5 9 11 13 15 6 4 8 10 12 14 1 2 3", (i - 1) % 15 + 1))

place(method) = sum [i = 1:methods] (name[i] eq method ? i : 0)
do for [i = 1:methods] { shade[i] = int(system("printf %d 0x" . substr(colour(i), 2, 7))) }

columns = tasks == 1 ? 1 : 2
rows = (tasks + columns - 1) / columns
panel_width = columns == 1 ? 640.0 : 480.0
panel_height = 340.0
longest = 0
do for [i = 1:methods] { longest = strlen(name[i]) > longest ? strlen(name[i]) : longest }
key_columns = columns * (longest > 20 ? 1 : 2)
key_lines = (methods + key_columns - 1) / key_columns
key_height = 20.0 * key_lines + 24
width = panel_width * columns
height = rows * panel_height + key_height

finite(e) = e > 0 && e < 1e300
shown(e) = e == 0 ? floor_at : e > 1e300 ? roof_at : e  # 0 and infinity stand at the axis' ends

do for [kind in "svg png"] {
  set output stem . "." . kind
  if (kind eq "svg") {
    set terminal svg size width, height font "DejaVu Sans,12" background "white"
  } else {
    set terminal pngcairo size width, height font "DejaVu Sans,9" background "white"
  }
  set multiplot
  set grid back linecolor rgb "#e4e4e4" linetype 1
  set lmargin 11; set rmargin 2; set tmargin 2.5; set bmargin 3.5
  set xlabel "ns a" . (strstrt("aeiou", per[1:1]) ? "n " : " ") . per offset 0, 0.4
  set format x "%g"
  unset key
  do for [t = 1:tasks] {
    task = nth(task_of_line, t)
    set size 1.0 / columns, panel_height / height
    set origin ((t - 1) % columns) * 1.0 / columns, 1 - ((t - 1) / columns + 1) * panel_height / height
    unset logscale
    set autoscale
    low = 1e300; high = 0; left = 1e300; right = 0; zero = 0; endless = 0
    stats "< " . lines(task) using (e = column(error), \
      left = $5 < left ? $5 : left, right = $6 > right ? $6 : right, \
      zero = zero || e == 0, endless = endless || e > 1e300, \
      low = finite(e) && e < low ? e : low, high = finite(e) && e > high ? e : high, 1) nooutput
    if (high == 0) { low = 0.1; high = 1 }
    decades = log10(high / low) + 1
    floor_at = 10 ** (floor(log10(low)) - 0.15 * decades)
    roof_at = high * 10 ** (0.15 * decades)
    spread = log10(right / left) + 0.2
    set logscale xy
    set xrange [left / 10 ** (0.7 * spread) : right * 10 ** (0.12 * spread)]
    bottom = (zero ? floor_at : low) / 10 ** (0.15 * decades)
    top = roof_at * (endless ? 10 : 1)
    set yrange [bottom : top]
    set ytics 10 ** floor(log10(low)), decades > 8 ? 100 : 10
    set xtics auto
    set for [k = -9:9] for [digit in (decades < 3 ? "2 5" : "")] ytics add \
      (zero && digit * 10.0 ** k < low ? 10.0 ** ceil(log10(low)) : digit * 10.0 ** k)
    set for [k = -9:9] for [digit in (spread < 1.5 ? "2 5" : "")] xtics add (digit * 10.0 ** k)
    set format y (decades > 4 ? "10^{%T}" : "%g")
    if (zero) { set ytics add ("0" floor_at) }
    if (endless) { set ytics add ("none" roof_at) }
    set ylabel (judged eq "max" ? "largest error" : "RMS error") offset 1, 0
    set title task font ",12" offset 0, -0.6 noenhanced
    named = "< " . front(task, (top / bottom) ** 0.055)
    corners = int(system(front(task, 1) . " | wc -l"))
    plot for [i = 1:(corners > 1)] named using 4:(shown(column(error))) with steps \
        linecolor rgb "#999999" linewidth 1.5, \
      "< " . lines(task) using 4:(shown(column(error))):5:6 with xerrorbars \
        pointsize 0 linecolor rgb "#777777", \
      "< " . lines(task) using 4:(shown(column(error))):(symbol(place(strcol(1)))): \
        (shade[place(strcol(1))]) with points pointsize 0.9 pointtype variable \
        linecolor rgb variable, \
      named using 4:(shown($12)):1 with labels right font ",10" offset -0.8, -0.4
  }
  # The key is a panel of its own.
  set size 1, key_height / height
  set origin 0, 0
  unset logscale; unset grid; unset border; unset tics; unset xlabel; unset ylabel; unset title
  set lmargin 0; set rmargin 0; set tmargin 0; set bmargin 0
  set xrange [0:1]; set yrange [0:1]
  set key center center horizontal maxcols key_columns samplen 1 font ",11"
  plot 0 linecolor rgb "white" notitle, for [i = 1:methods] keyentry with points pointtype symbol(i) \
    linecolor rgb colour(i) title name[i]
  unset multiplot
  set border; set tics
}
