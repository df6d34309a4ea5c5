heading "Contact"
run contact_error_time "$(size 128 1024)" "$(size 64 256)"

text <<'END'
Two smooth steel spheres against Hertz, N × N cells, residual 1e-8: what the cells leave. Points are N = 32, 64, …
END
picture contact-grid "Error of Hertz's contact against seconds" <<'END'
set ylabel 'relative error'
names = "p0 approach area"
plot for [t=1:2] for [k=1:3] '@contact_error_time-1.tsv' using ($10):($3 == t ? abs(column(3 + k)) : NaN) \
  with linespoints linetype k pointtype (t == 1 ? 7 : 6) dashtype t title word(names, k).', '.t.(t == 1 ? ' thread' : ' threads')
END
table contact_error_time-1
claim "The greatest pressure errs by at most 0.25 (Δx/a)², the approach by 0.1 (Δx/a)²." contact_error_time-1 1 \
  'abs($c["p0_error"]) <= 0.25 * (3 / 0.936109 / $c["n"]) ^ 2 && abs($c["approach_error"]) <= 0.1 * (3 / 0.936109 / $c["n"]) ^ 2'
claim "The residual is met, whatever the grid and the threads." contact_error_time-1 1 '$c["residual"] <= 1e-8'
text <<'END'
Convolutions do not grow with the grid: nested grids leave the finest one only the contact's edge to settle. Pressure and
approach are of order two though the pressure's slope is infinite at the edge; the area counts whole cells of a circle
and can be no better than a part of a cell on its rim. Set-up is a third of the time on a small grid and an eighth on a
large one: for many surfaces on one grid the influence is made once.

Six scenes to a tolerance, beside Polonsky and Keer's conjugate gradients and the projected gradient, which apply the same
convolution: smooth (A), rough (B), rough with a limit pressure (B2), periodic with a tenth and nine tenths in contact
(C10, C90), and A on flat cells (D).
END
picture contact-tolerance "Residual against seconds, scene by scene" <<'END'
set terminal pngcairo size 860,560
set multiplot layout 2,3 margins 0.08,0.98,0.1,0.9 spacing 0.06,0.14
unset key
set xlabel 'seconds' offset 0,0.5
methods = "guarded polonsky-keer projected-gradient"
scenes = "A B B2 C10 C90 D"
do for [s=1:6] {
  set title word(scenes, s) offset 0,-0.5
  set ylabel (s % 3 == 1 ? 'residual' : '') offset 1
  if (s == 1) { set key at screen 0.5,0.985 center top maxrows 1 } else { unset key }
  plot for [m=1:3] '@contact_error_time-2.tsv' \
    using 10:(strcol(1) eq word(scenes, s) && strcol(3) eq word(methods, m) ? $12 : NaN) \
    with linespoints pointtype 7 title word(methods, m)
}
unset multiplot
END
table contact_error_time-2 '$c["tol"] == 1e-8' case n method tol p_error area_error convolutions preconditionings setup_seconds seconds residual
claim "Every scene is solved to every tolerance asked." contact_error_time-2 '$c["method"] == "guarded"' '$c["residual"] <= $c["tol"]'
claim "The area is right to 1e-2 at a tolerance of 1e-4, and the greatest pressure to 1e-3." contact_error_time-2 \
  '$c["method"] == "guarded" && $c["tol"] == 1e-4' 'abs($c["area_error"]) <= 1e-2 && abs($c["p_error"]) <= 1e-3'
text <<'END'
Conjugate gradients that take whichever cells are in contact as given lose their memory each time a cell enters or
leaves, which on rough surfaces is at nearly every step: at 256 × 256 cells they need four to eighteen times the
convolutions of the solver here, most on rough spheres, and on the smooth scenes A and D they never come to 1e-10 within
600. The projected gradient does not mind cells that come and go, and overtakes them where there are many, though it has no
memory at all. Four more digits cost the solver a half to three quarters of what the first four did: what takes the time is to find
the cells.
END
