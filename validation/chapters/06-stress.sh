heading "Stress"
run stress_error_time "$(size 64 512)"
run stress_request_time "$(size 128 512)"

text <<'END'
Below a Hertz contact at rest and sliding (μ = 0.3), against the closed forms: the largest error of any component in a layer
through the maximum, in units of the largest pressure. Points are N = 32, 64, …
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
claim "The error of the stress is at most 0.25 (h/a)² of the largest pressure, on n cells of h = 3a/n." stress_error_time-1 1 '$c["error"] <= 0.25 * (3 / $c["n"]) ^ 2'
claim "The search finds the largest stress within 0.25 (h/a)² + 8e-5." stress_error_time-1 1 'abs($c["maximum"]) <= 0.25 * (3 / $c["n"]) ^ 2 + 8e-5'
text <<'END'
The error comes from the cells, not from the summation: order two, with nearly the same constant at rest and sliding. With
friction a layer costs only half as much again, or somewhat more, because it shares the transform of the pressure. The depth of
the maximum is far less accurate than its value, as for any flat maximum.

The largest value among the points of a volume: how many layers are needed without a search?
END
table stress_error_time-2
text <<'END'
Eight well-placed layers are as good as sixty-four (sliding, uniform); sixteen can be worse than eight (hertz, geometric). If the
depth is unknown beforehand, layers are not reliable. Geometric layers are dense at the surface, where rough contacts yield, and
sparse where smooth contacts do. The search (`--maximum`) costs some sixteen layers, and its error is that of the cells.

Cost of each request, in processor seconds, 32 or 64 layers:
END
table stress_request_time-1
claim "Deep layers on wider cells differ by at most 2e-6 of the largest pressure." stress_request_time-1 '$c["request"] == "volume_adapted"' '$c["error"] <= 2e-6'
text <<'END'
At 128 cells a volume at full resolution costs less than twice one with deep layers on wider cells; at 512 cells five times,
because most layers are then many cells deep. A single component costs a quarter of six with von Mises, a section a fifth or
less.
END
