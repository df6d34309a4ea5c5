heading "Kernel: the autocorrelation equations"
run acf_error_time "$(size 15 127)"

text <<'END'
Exponential targets that have fallen to e⁻ᶜ at the last of n × n lags. The error is the largest over **all** lags of the
plane, against the target without any cut. Points on a line are c = 4.6, 6, 7, 9, 11.5, 14.
END
picture kernel "Error over all lags against seconds, n x n lags" <<'END'
set ylabel 'largest error over all lags'
lags = "7x7 15x15 31x31 63x63 127x127"
set key title 'lags'
plot for [i=1:words(lags)] '@acf_error_time-1.tsv' using 7:(strcol(2) eq 'symmetric' && strcol(3) eq word(lags, i) ? $5 : NaN) \
       with linespoints linetype i pointtype 7 title word(lags, i), \
     for [i=1:words(lags)] '' using 7:(strcol(2) eq 'oriented' && strcol(3) eq word(lags, i) ? $5 : NaN) \
       with linespoints linetype i pointtype 6 dashtype 2 title (i == 1 ? 'oriented' : ''), \
     '' using 7:(strcol(2) eq 'patir' ? $5 : NaN) with points pointtype 2 linecolor rgb 'black' title 'Patir'
END
table acf_error_time-1 '$c["c"] == 4.6 || $c["c"] == 11.5' formulation lags c error mirrored seconds residual steps products ratio
claim "A residual of at most 1e-10 wherever the answer is called exact." acf_error_time-1 '$c["answer"] == "exact"' '$c["residual"] <= 1e-10'
claim "Lags of 6 decay lengths leave an error below 1e-3, of 11.5 below 4e-6." acf_error_time-1 \
  '$c["formulation"] != "patir" && ($c["c"] == 6 || $c["c"] == 11.5)' '$c["error"] < ($c["c"] == 6 ? 1e-3 : 4e-6)'
claim "Patir's formulation errs by more than 5e-2 at the mirrored lags (p, -q), whatever its residual." acf_error_time-1 \
  '$c["formulation"] == "patir"' '$c["mirrored"] > 5e-2'
text <<'END'
The lines lean to the left: a smaller error costs less. The more the target has fallen at its last lag, the farther its
equations are from having no solution, and the fewer products Newton takes; what it does cost is a kernel that is wide for
its correlation length. Patir's equations are met as exactly as the others and still draw the wrong surface, for they
prescribe one quadrant of lags; and they take several times as long at 63 × 63 lags, where they are worse conditioned and
have no symmetry to save work.

The other ways to solve the same equations, at c = 4.6:
END
table acf_error_time-2 1 method formulation lags error seconds residual products answer
claim "No answer of another method is called exact with a residual above 1e-10." acf_error_time-2 '$c["answer"] == "exact"' '$c["residual"] <= 1e-10'
text <<'END'
Conjugate gradients, the method of 2009, do converge, but take three times as many products for twice as many lags a
side where Newton takes a quarter more: five times Newton's time at 7 × 7 lags, more than twenty times at 31 × 31. Anderson's
fixed point, a yardstick of this study alone, keeps up with Newton where the kernel is even, and fails on Patir's formulation at 31 × 31, which it says. The
spectral root, which solves nothing, errs less over all lags than the exact solutions of this cut: it does not stop at the
lags prescribed, but none of them is exact.
END
