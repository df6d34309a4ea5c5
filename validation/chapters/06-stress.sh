heading "Stress"
run stress_error_time "$(size 64 512)"
run stress_request_time "$(size 128 512)"

text <<'END'
Below Hertz's contact at rest and sliding (μ = 0.3), against the closed forms: the largest error of any component in a
layer through the maximum, in units of the largest pressure. Points are N = 32, 64, …
END
picture stress "Error of a layer against its seconds" <<'END'
set ylabel 'error / p_0'
cases = "hertz sliding"
plot for [i=1:2] '@stress_error_time-1.tsv' using 9:(strcol(1) eq word(cases, i) ? $3 : NaN) \
       with linespoints linetype i pointtype 7 title word(cases, i).', any component', \
     for [i=1:2] '' using 9:(strcol(1) eq word(cases, i) ? abs($5) : NaN) \
       with linespoints linetype i pointtype 6 dashtype 2 title word(cases, i).', maximum of von Mises'
END
table stress_error_time-1
claim "The stress errs by 0.25 (h/a)² of the largest pressure at most on n cells of h = 3a/n." stress_error_time-1 1 '$c["error"] <= 0.25 * (3 / $c["n"]) ^ 2'
claim "The search finds the largest stress within 0.25 (h/a)² + 8e-5." stress_error_time-1 1 'abs($c["maximum"]) <= 0.25 * (3 / $c["n"]) ^ 2 + 8e-5'
text <<'END'
The error is the cells', not the sum's: of order two, with nearly the same constant at rest and sliding. Friction makes a
layer dearer by a half only, or somewhat more, for it shares the pressure's transform. The depth of the maximum is known far
worse than its value, as that of any flat maximum.

The largest value among the points of a volume: how many layers does a user need who does not search?
END
table stress_error_time-2
text <<'END'
Eight layers that happen to lie well are as good as sixty-four (sliding, uniform), sixteen can be worse than eight (hertz,
geometric): where nobody knows the depth beforehand, layers do not tell. Geometric ones gather at the surface, where rough
contacts yield, and are far apart where smooth ones do. The search (`--maximum`) takes some sixteen layers and errs by what
the cells do.

What each request costs, processor seconds, 32 or 64 layers:
END
table stress_request_time-1
claim "Deep layers from wider cells differ by at most 2e-6 of the largest pressure." stress_request_time-1 '$c["request"] == "volume_adapted"' '$c["error"] <= 2e-6'
text <<'END'
At 128 cells a volume in full costs under twice that of one whose deep layers come from wider cells, at 512 cells five times
as much: there most layers are deep, in cells. A single component costs a quarter of six with von Mises, a section a fifth or
less.
END
