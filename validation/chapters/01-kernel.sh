heading "Kernel: the autocorrelation equations"
run acf_error_time "$(size 15 127)"

text <<'END'
Exponential targets that fall to e⁻ᶜ at the last of n × n lags. The error is the largest over **all** lags of the plane,
against the target without a cut. Points on a line are c = 4.6, 6, 7, 9, 11.5, 14.
END
picture kernel "Error over all lags against seconds, n x n lags" <<'END'
set ylabel 'largest error over all lags'
lags = "7x7 15x15 31x31 63x63 127x127"
set key title 'lags'
plot for [i=1:words(lags)] '@acf_error_time-1.tsv' using (column('seconds')):(strcol(2) eq 'symmetric' && strcol(3) eq word(lags, i) ? $5 : NaN) \
       with linespoints linetype i pointtype 7 title word(lags, i), \
     for [i=1:words(lags)] '' using (column('seconds')):(strcol(2) eq 'oriented' && strcol(3) eq word(lags, i) ? $5 : NaN) \
       with linespoints linetype i pointtype 6 dashtype 2 title (i == 1 ? 'oriented' : ''), \
     '' using (column('seconds')):(strcol(2) eq 'patir' ? $5 : NaN) with points pointtype 2 linecolor rgb 'black' title 'Patir'
END
table acf_error_time-1 '$c["c"] == 4.6 || $c["c"] == 11.5' formulation lags c error mirrored seconds residual steps products ratio
claim "Every answer called exact has a residual of at most 1e-10." acf_error_time-1 '$c["answer"] == "exact"' '$c["residual"] <= 1e-10'
claim "The error is below 1e-3 with lags of 6 decay lengths, below 4e-6 with 11.5." acf_error_time-1 \
  '$c["formulation"] != "patir" && ($c["c"] == 6 || $c["c"] == 11.5)' '$c["error"] < ($c["c"] == 6 ? 1e-3 : 4e-6)'
claim "Patir's formulation has an error above 5e-2 at the mirrored lags (p, -q), whatever its residual." acf_error_time-1 \
  '$c["formulation"] == "patir"' '$c["mirrored"] > 5e-2'
text <<'END'
The lines lean to the left: a smaller error costs less. The further the target has fallen at its last lag, the further the
equations are from having no solution, and the fewer products Newton's method needs. The price is a kernel that is wide for
its correlation length. Patir's equations are met as exactly as the others and still draw the wrong surface, because they
prescribe one quadrant of lags only. They take several times as long at 63 × 63 lags, where they are worse conditioned and
have no symmetry that saves work.

Other methods for the same equations, at c = 4.6:
END
table acf_error_time-2 1 method formulation lags error seconds residual products answer
claim "No other method calls an answer exact that has a residual above 1e-10." acf_error_time-2 '$c["answer"] == "exact"' '$c["residual"] <= 1e-10'
text <<'END'
Conjugate gradients, the method of 2009, converge. For twice as many lags a side they need three times as many products, and
Newton's method a quarter more: five times Newton's time at 7 × 7 lags, more than twenty times at 31 × 31. Anderson's fixed
point is as fast as Newton's method for even kernels. It fails on Patir's formulation at 31 × 31 lags, and says so. Both exist
only in this comparison. The spectral root solves no equations. Its error over all lags is smaller than that of the exact solutions
of this cut, because it does not end at the prescribed lags; but it is exact at none of them.
END
