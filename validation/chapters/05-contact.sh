heading "Contact"
run contact_error_time "$(size 128 1024)" "$(size 64 256)"

text <<'END'
Two smooth steel spheres against Hertz, N × N cells, residual 1e-8: the discretisation error. Points are N = 32, 64, …
END
picture contact-grid "Error of Hertz's contact against seconds" <<'END'
set ylabel 'relative error'
names = "p0 approach area"
plot for [t=1:2] for [k=1:3] '@contact_error_time-1.tsv' using (column('seconds')):($3 == t ? abs(column(3 + k)) : NaN) \
  with linespoints linetype k pointtype (t == 1 ? 7 : 6) dashtype t title word(names, k).', '.t.(t == 1 ? ' thread' : ' threads')
END
table contact_error_time-1
claim "The error of the greatest pressure is at most 0.25 (Δx/a)², of the approach 0.1 (Δx/a)²." contact_error_time-1 1 \
  'abs($c["p0_error"]) <= 0.25 * (3 / 0.936109 / $c["n"]) ^ 2 && abs($c["approach_error"]) <= 0.1 * (3 / 0.936109 / $c["n"]) ^ 2'
claim "The residual is met on every grid, with any number of threads." contact_error_time-1 1 '$c["residual"] <= 1e-8'
text <<'END'
The number of convolutions does not grow with the grid: after the coarser grids, the finest one only has to settle the edge of
the contact. Pressure and approach converge with order two, although the slope of the pressure is infinite at the edge. The area
counts whole cells of a circle, so its error is a part of a cell on the rim. Set-up takes a third of the time on a small grid and
an eighth on a large one; for many surfaces on one grid the influence coefficients are computed once.

Six scenes to a tolerance, beside Polonsky and Keer's conjugate gradients and the projected gradient, which apply the same
convolution: smooth and rough spheres, rough ones with a limit pressure, a periodic surface with a tenth and with nine
tenths (most) in contact, and the smooth spheres on oblong cells.
END
picture contact-tolerance "Residual against seconds, scene by scene" <<'END'
set terminal pngcairo size 860,560
set multiplot layout 2,3 margins 0.08,0.98,0.1,0.9 spacing 0.06,0.14
unset key
set xlabel 'seconds' offset 0,0.5
methods = "guarded polonsky-keer projected-gradient"
array scenes[6] = ['smooth', 'rough', 'rough, limited', 'periodic, tenth', 'periodic, most', 'smooth, oblong']
do for [s=1:6] {
  set title scenes[s] offset 0,-0.5
  set ylabel (s % 3 == 1 ? 'residual' : '') offset 1
  if (s == 1) { set key at screen 0.5,0.985 center top maxrows 1 } else { unset key }
  plot for [m=1:3] '@contact_error_time-2.tsv' \
    using (column('seconds')):(strcol(1) eq scenes[s] && strcol(3) eq word(methods, m) ? column('residual') : NaN) \
    with linespoints pointtype 7 title word(methods, m)
}
unset multiplot
END
table contact_error_time-2 '$c["tol"] == 1e-8' case n method tol p_error area_error convolutions preconditionings setup_seconds seconds residual
claim "Every scene is solved to every tolerance." contact_error_time-2 '$c["method"] == "guarded"' '$c["residual"] <= $c["tol"]'
claim "At a tolerance of 1e-4 the error of the area is at most 1e-2, of the greatest pressure 1e-3." contact_error_time-2 \
  '$c["method"] == "guarded" && $c["tol"] == 1e-4' 'abs($c["area_error"]) <= 1e-2 && abs($c["p_error"]) <= 1e-3'
text <<'END'
Polonsky and Keer's conjugate gradients lose their conjugacy each time a cell enters or leaves the contact, on rough surfaces at
nearly every step. At 256 × 256 cells and 1e-8 they need four to twenty-two times the convolutions of Asperity's solver, most on rough
spheres. On smooth spheres they never reach 1e-10 within 600. Cells that come and go do not disturb the projected
gradient, and it overtakes them where there are many such cells, although it has no memory. Four more digits cost the solver a half
to four fifths of the first four: most of the time goes into finding the cells in contact.
END
heading "Errors of the grid, stated and true"
run contact_grid_error $(size "105 256 1 0 45" "252 2048 1 0 180")
text <<'END'
`--add grid_errors` states by how much the grid may put each figure off, from the same contact on half and a quarter of the cells
along each side. Random scenes of seven kinds (smooth, rough, at a limit pressure, periodic, oblong, under a prescribed approach, measured) are
solved on 64 to 512 cells a side and, for the truth, the same surface on four times as many. `fine` are those on more than 128.
`hard` ones are of nine kinds more, where estimates of errors break: spheres and ellipsoids that yield (cap, capped-ellipsoid),
flats that yield, lays and waves of three to five cells, contacts of three to six cells a radius, cells three times as long as wide, and
sliding, on 48 to 128 cells. `within` is the share of scenes whose true error is no more than the stated one; `ratio` is the median of
stated over true.
END
table contact_grid_error-1
text <<'END'
The areas' errors come from the outline alone, that of the stiffness from the outline of the cells below the limit pressure. The
depth of the largest stress is the least certain: two layers of nearly the same stress may change places from one grid to the next. On
many cells no layers do, and the stated error of the depth is then far too large. The factors come from
other scenes: `contact_grid_error 126 1024 11`, and those of stiffness, depth and energies from `70 512 11`, `105 512 21` and 180
hard scenes of two other seeds.

On 1024 cells, with truths on 4096 (`contact_grid_error 2 4096 3 1024`, 7 GB), a smooth and a rough sphere lie within all their
stated errors.

The cost, in that of the contact itself, by cells a side; on few of them it is mostly that of the set-up:
END
table contact_grid_error-2
claim "Of all scenes, hard ones, and but for the depth of fine ones, nine in ten have true errors within the stated ones, for every \
figure of 20 scenes or more." contact_grid_error-1 \
  '($c["kind"] ~ /^(all|hard)$/ || $c["kind"] == "fine" && $c["figure"] != "depth") && $c["scenes"] >= 20' \
  '$c["within"] >= '"$(size 0.85 0.9)"  # of 105 scenes 0.90 ± 0.03
claim "But for the depth the stated error is at most five times the true one in the median of all scenes, and of fine ones." \
  contact_grid_error-1 '($c["kind"] == "all" || $c["kind"] == "fine") && $c["figure"] != "depth" && $c["scenes"] >= 20' \
  '$c["ratio"] <= 5'
