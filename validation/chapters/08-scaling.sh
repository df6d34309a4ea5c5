heading "Scaling"
run scaling "$(size 256 4096)"

text <<'END'
Seconds and peak memory of every stage on N × N cells. `transforms` measures a stage in padded r2c transforms, of (2N)²
points; `doubles` its memory in doubles a cell. A kernel is solved, and moments are summed, on one thread.
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
set format y '%g'
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
text <<'END'
An exponent of one is what the method promises; what is above it comes from memory farther away. Rough contacts are the
exception: an exponential autocorrelation shows more and smaller asperities on each finer grid, and those take more
convolutions. The `transforms` of nearly every other stage fall with N, for a plain transform of (2N)² points leaves the cache
between N = 256 and 1024, while the stages, which prune the padding and work in blocks, do so later and in smaller pieces.

Two threads gain where the work is long and in independent pieces: a spectrum, the layers of a volume. A contact does its work
in many short steps, most on coarser grids, and gains from some 512 cells along a side on; on small ones the threads wait for
one another.

A surface takes less memory than its own heights, for it is drawn in bands. A contact takes some ten doubles a cell. The
search for the largest stress, which keeps six components and their transforms at several resolutions, takes five times
that, and is what limits the grid.
END
