heading "Surface: the moving average"
run synthesis_time "$(size 256 2048)"

text <<'END'
A surface is exact to round-off for its kernel, so its error is that of the kernel's autocorrelation. The target is exponential
with a decay length of five samples, and the lags cover c decay lengths. The picture shows what accuracy costs in the kernel, and
in each surface.
END
picture surface "Error of the autocorrelation against seconds" <<'END'
set ylabel 'largest error over all lags'
plot '@synthesis_time-4.tsv' using (column('kernel')):4 with linespoints pointtype 7 title 'kernel, once', \
     '' using (column('surface')):4 with linespoints pointtype 6 title 'each surface'
END
table synthesis_time-4
text <<'END'
Five more digits of autocorrelation cost at most twice as much per surface, although the kernel has twenty times as many
coefficients: transforms apply it in tiles that stay in the cache, and a wider kernel only wastes a wider margin of each tile.

Cost on N × N heights with a kernel of K × K. `noise` and `transforms` are unavoidable; `ratio` is the time over that of the
transforms of the whole padded surface.
END
table synthesis_time-2
text <<'END'
For large surfaces and small kernels the ratio falls below one: the transform of the whole exceeds the cache, tiles do not. With a
small kernel the noise takes a third of the time. Two threads gain nothing on small surfaces, which consist of pieces of some
0.1 ms, and nothing at all while the second core is busy otherwise.

Direct sum and transform, and `model`, the predicted ratio that decides between them:
END
table synthesis_time-3 '$c["N"] > 64 || $c["K"] > 5'
text <<'END'
The model counts the sums only. The seconds include the noise, which takes nearly all the time below K = 9. So the measured ratio is
nearer to one than the model. Where the model is near one and may choose wrongly, little is lost.

Peak memory, and the memory that the program predicts, in MB:
END
table synthesis_time-1
