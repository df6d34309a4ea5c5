heading "Surface: the moving average"
run synthesis_time "$(size 256 2048)"

text <<'END'
A surface is exact to round-off for its kernel; its error is that of the kernel's autocorrelation. Exponential target of
five samples' decay length, lags covering c decay lengths: what exactness costs in the kernel, and in each surface.
END
picture surface "Error of the autocorrelation against seconds" <<'END'
set ylabel 'largest error over all lags'
plot '@synthesis_time-4.tsv' using 5:4 with linespoints pointtype 7 title 'kernel, once', \
     '' using 6:4 with linespoints pointtype 6 title 'each surface'
END
table synthesis_time-4
text <<'END'
Four more digits of autocorrelation make each surface dearer by less than a factor of two, for the kernel is applied by
transforms in tiles that stay in the cache, and a wider kernel only wastes a wider margin of them.

Cost on N × N heights with a kernel of K × K: `noise` and `transforms` are what cannot be saved, `ratio` what is left over
the transforms of the whole padded surface.
END
table synthesis_time-2
text <<'END'
The ratio falls below one: tiles need less than one transform of the whole, which does not fit into the cache. Of a
small kernel the noise is a third of all time. Two threads gain little where the surface is small, for a band's noise and
tiles are handed out in pieces of some 0.1 ms.

Direct sum and transform, and `model`, the ratio that decides between them:
END
table synthesis_time-3 '$c["N"] > 64 || $c["K"] > 5'
text <<'END'
The model errs by up to a factor of three where noise, which it leaves out, is all there is; there the choice matters
least. Peak memory, and what the program says beforehand that it will take, in MB:
END
table synthesis_time-1
