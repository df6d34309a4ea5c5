heading "Published results"
run_script published validation/published/run $(size "westergaard full_contact" "")
text <<'END'
Figures of the literature, run by the tools from Python (`validation/published/`). `error` is what the tools state for their figure, the
standard error of a mean over surfaces, or what coarser cells change; `doubt` is that of the published one. Of differences that are
chance alone a third exceeds one standard error: `explained` tells of once both, the claims are of twice.

In the pictures open symbols, with a broad bar for their doubt, are the published figures; full ones, with a thin bar for their error, come
from the tools. Below, the difference over both.
END

# beside NAME XLABEL [SETTINGS [LOWER]]: the picture of a result; gnuplot's commands for both parts, and for the lower one.
beside() {
  local blocks plots
  blocks=$(rows published-1 "\$1 == \"$1\"" | awk -F'\t' 'NR > 1 {
    if (!($2 in block)) name[++names] = $2
    block[$2] = block[$2] $3 "\t" $4 "\t" $5 "\t" $6 "\t" $7 "\t" $8 "\n"
  } END { for (k = 1; k <= names; ++k) print block[name[k]] "\n" }')
  plots=$(rows published-1 "\$1 == \"$1\"" | awk -F'\t' 'NR > 1 && !seen[$2]++ { print $2 }')
  picture "published-$1" "$title: published and here" <<END
set terminal pngcairo size 760,520 font 'DejaVu Sans,10' background rgb 'white'
unset logscale
set format xy '%g'
set key at screen 0.12, 0.99 left top Left reverse maxrows 3 samplen 1 noenhanced
\$data << EOD
$blocks
EOD
array name[$(wc -l <<<"$plots")] = [$(sed 's/.*/"&"/' <<<"$plots" | paste -sd,)]
count = |name|
${3:-}
set offsets graph 0.05, graph 0.05, graph 0.05, graph 0.05
set bars 0
set multiplot
set lmargin at screen 0.11; set rmargin at screen 0.97; set tmargin at screen 0.85; set bmargin at screen 0.40
set xlabel ''; set format x ''
plot for [k=1:count] \$data index k-1 using 1:2:5 with yerrorbars linetype k linewidth 9 pointtype 0 linecolor rgb '#c8c8c8' notitle, \\
  for [k=1:count] \$data index k-1 using 1:2 with linespoints linetype k dashtype 2 pointtype 6 pointsize 1.4 notitle, \\
  for [k=1:count] \$data index k-1 using 1:3:4 with yerrorbars linetype k linewidth 1.5 pointtype 7 pointsize 0.7 title name[k]
set tmargin at screen 0.37; set bmargin at screen 0.10
set xlabel '$2'; set format x '%g'; unset logscale y; unset key
set ylabel "difference /\\n(error + doubt)"; set yrange [-2.4:2.4]; set ytics -2,1,2
set offsets graph 0.05, graph 0.05, 0, 0
${4:-}
plot for [k=1:count] \$data index k-1 using 1:(\$6/(\$4+\$5)) with points linetype k pointtype 7 pointsize 0.9 notitle
unset multiplot
END
}

for name in $(validation/published/run --names); do
  rows published-1 "\$1 == \"$name\"" | awk 'END { exit NR < 2 }' || continue  # not run
  title=$(validation/published/run --title "$name")
  heading "$title"
  validation/published/run --text "$name" | text
  table published-1 "\$1 == \"$name\"" quantity at published here error doubt difference explained
  case $name in
    westergaard | egg_box) beside "$name" 'mean pressure / p*' ;;
    punches) beside "$name" 'power n (8: the square punch)' ;;
    hertz) beside "$name" 'b/a' ;;
    sliding) beside "$name" 'coefficient of friction' ;;
    area_law | gap_and_stiffness) beside "$name" 'p / (E* Sdq)' 'set logscale x' ;;
    rough_sphere) beside "$name" 'σR/a0²' 'set logscale x' ;;
    peaks) beside "$name" 'correlation of neighbours' ;;
    summits) beside "$name" 'α' ;;
    kernels) beside "$name" 'r/l' 'set logscale y' ;;
    line_contact) beside "$name" 'z/a' ;;
    plastic) beside "$name" 'E* Sdq / H' 'set logscale xy' ;;
    off) beside "$name" 'p/p*, b/a, or 1' '' 'set yrange [-100:100]; set ytics autofreq' ;;
    full_contact) beside "$name" 'H' 'set yrange [0.4:0.6]' ;;
    *) beside "$name" 'H' ;;
  esac
  case $name in
    off) claim "These published figures differ from the tools' by more than the errors of both." published-1 '$1 == "off"' \
      'abs($c["difference"]) > $c["error"] + $c["doubt"]' ;;
    *) claim "$title: every figure lies within twice the stated errors of both." published-1 "\$1 == \"$name\"" \
      'abs($c["difference"]) <= 2 * ($c["error"] + $c["doubt"])' ;;
  esac
done
