heading "Scaling"
run scaling "$(size 256 4096)"

text <<'END'
Seconds and peak memory of every stage on N × N cells. `transforms` measures a stage in padded r2c transforms, of (2N)²
points; `doubles` its memory in doubles a cell.
END
picture scaling "Seconds against N, one thread" <<'END'
set xlabel 'N'
set ylabel 'seconds'
set logscale x 2
set format x '%.0f'
stages = "kernel synthesis moments acf psd smooth rough volume maximum"
plot for [i=1:words(stages)] '@scaling-1.tsv' using 2:(strcol(1) eq word(stages, i) && $3 == 1 ? $4 : NaN) \
  with linespoints linetype i pointtype 7 title word(stages, i), \
  '' using 2:(strcol(1) eq 'synthesis' && $3 == 1 ? $4 / $5 : NaN) with lines linewidth 2 dashtype 2 linecolor rgb 'black' title 'one r2c'
END
picture scaling-memory "Peak memory against N, one thread" <<'END'
set xlabel 'N'
set ylabel 'MB'
set logscale x 2
set format x '%.0f'
set format y '%.0f'
stages = "kernel synthesis moments acf psd smooth rough volume maximum"
plot for [i=1:words(stages)] '@scaling-1.tsv' using 2:(strcol(1) eq word(stages, i) && $3 == 1 ? $6 : NaN) \
  with linespoints linetype i pointtype 7 title word(stages, i), \
  '' using 2:(strcol(1) eq 'synthesis' && $3 == 1 ? 8e-6 * $2 ** 2 : NaN) with lines linewidth 2 dashtype 2 linecolor rgb 'black' title 'the heights'
END
table scaling-1 '$c["N"] >= 256'
text <<'END'
The exponent of seconds against N² log N, fitted from N = 256 on:
END
table scaling-2
