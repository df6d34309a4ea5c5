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
Five more digits of autocorrelation make each surface dearer by a factor of two to three, not by the twenty-fold number
of coefficients: the kernel is applied by transforms in tiles that stay in the cache, and a wider one wastes a wider margin
of them.

Cost on N × N heights with a kernel of K × K: `noise` and `transforms` are what cannot be saved, `ratio` what is left over
the transforms of the whole padded surface.
END
table synthesis_time-2
text <<'END'
Where the surface is large and the kernel small the ratio falls below one: the transform of the whole leaves the cache,
tiles do not. Of a small kernel the noise is a third of all time. Two threads gain nothing on small surfaces, which are done
in pieces of some 0.1 ms, and nothing anywhere while the second core is busy with something else.

Direct sum and transform, and `model`, the ratio that decides between them:
END
table synthesis_time-3 '$c["N"] > 64 || $c["K"] > 5'
text <<'END'
The model counts the sums alone. The seconds have the noise in them too, which is nearly all there is below K = 9: so the
measured ratio lies nearer to one than the model, and where the model is near to one, and may choose wrongly, little is lost.

Peak memory, and what the program says beforehand that it will take, in MB:
END
table synthesis_time-1
