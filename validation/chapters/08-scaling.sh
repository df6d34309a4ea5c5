heading "Scaling"
run scaling "$(size 256 4096)"

text <<'END'
Seconds and peak memory of every stage on N × N cells. `transforms` is the time in padded r2c transforms of (2N)² points, `doubles`
the memory in doubles per cell. Kernel and moments use one thread.
END
picture scaling "Seconds against N, one thread" <<'END'
set xlabel 'N'
set ylabel 'seconds'
set logscale x 2
set format x '%.0f'
stages = "kernel synthesis moments acf psd smooth rough volume maximum"
plot for [i=1:words(stages)] '@scaling-1.tsv' using 2:(strcol(1) eq word(stages, i) && $3 == 1 ? $4 : NaN) \
  with linespoints linetype i pointtype 7 title word(stages, i), \
  '' using 2:(strcol(1) eq 'synthesis' && $3 == 1 ? $4 / column('transforms') : NaN) with lines linewidth 2 dashtype 2 linecolor rgb 'black' title 'one r2c'
END
picture scaling-memory "Peak memory against N, one thread" <<'END'
set xlabel 'N'
set ylabel 'MB'
set logscale x 2
set format x '%.0f'
set format y '%g'
stages = "kernel synthesis moments acf psd smooth rough volume maximum"
plot for [i=1:words(stages)] '@scaling-1.tsv' using 2:(strcol(1) eq word(stages, i) && $3 == 1 ? column('MB') : NaN) \
  with linespoints linetype i pointtype 7 title word(stages, i), \
  '' using 2:(strcol(1) eq 'synthesis' && $3 == 1 ? 8e-6 * $2 ** 2 : NaN) with lines linewidth 2 dashtype 2 linecolor rgb 'black' title 'the heights'
END
table scaling-1 '$c["N"] >= 256'
text <<'END'
What doubling N takes: the exponent of seconds against N² log N, fitted from N = 256 on; time and memory of the largest grid
over those of the grid before; and, extrapolated from the largest, the N whose memory is 16 GiB, the given field included, and its hours:
END
table scaling-2
text <<'END'
The methods promise an exponent of one; slower memory explains what exceeds it. Rough contacts need a few convolutions more on
each finer grid, for an exponential autocorrelation shows more and smaller asperities there. The `transforms` of nearly every
other stage fall with N, because a plain transform of (2N)² points exceeds the cache between N = 256 and 1024. The stages skip the
padding and work in blocks, so they exceed it later and in smaller pieces.

Two threads help where the work consists of long, independent pieces: a spectrum, the layers of a volume. A contact consists of many
short steps, most of them on coarser grids, and gains from some 512 cells along a side on; on small grids the threads wait for
one another.

Drawing a surface needs less memory than its heights, because it is drawn in bands. A contact needs some ten doubles a cell and
limits the grid. Layers of a volume take one field each as they are written; the search for the largest stress looks at tiles and
wide cells, and takes less than the contact.
END
