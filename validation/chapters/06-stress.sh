heading "Stress"
run stress_error_time "$(size 64 512)"
run stress_request_time "$(size 128 512)"
run stress_edge "$(size 128 512)"

text <<'END'
Below a Hertz contact at rest and sliding (μ = 0.3), against the closed forms: the largest error of any component in a layer
through the maximum, in units of the largest pressure. Points are N = 32, 64, …
END
picture stress "Error of a layer against its seconds" <<'END'
set ylabel 'error / p_0'
cases = "hertz sliding"
plot for [i=1:2] '@stress_error_time-1.tsv' using (column('seconds')):(strcol(1) eq word(cases, i) ? $3 : NaN) \
       with linespoints linetype i pointtype 7 title word(cases, i).', any component', \
     for [i=1:2] '' using (column('seconds')):(strcol(1) eq word(cases, i) ? abs($5) : NaN) \
       with linespoints linetype i pointtype 6 dashtype 2 title word(cases, i).', maximum of von Mises'
END
table stress_error_time-1
claim "The error of the stress is at most 0.25 (h/a)² of the largest pressure, on n cells of h = 3a/n." stress_error_time-1 1 '$c["error"] <= 0.25 * (3 / $c["n"]) ^ 2'
claim "The search finds the largest stress within 0.25 (h/a)² + 2e-6." stress_error_time-1 1 'abs($c["maximum"]) <= 0.25 * (3 / $c["n"]) ^ 2 + 2e-6'
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
sparse where smooth contacts do. The search (`--maximum`) looks at some twenty depths, at most of them in few cells, and its error is that of the cells.

Cost of each request, in processor seconds, 32 or 64 layers:
END
table stress_request_time-1
claim "Deep layers on wider cells differ by at most 2e-6 of the largest pressure." stress_request_time-1 '$c["request"] == "volume_adapted"' '$c["error"] <= 2e-6'
text <<'END'
At 128 cells a volume at full resolution costs less than twice one with deep layers on wider cells; at 512 cells five times,
because most layers are then many cells deep. A single component costs a quarter of six with von Mises, a section a fifth or
less.

Sliding. Smith & Liu's √J2/p0 (1953), below the surface for μ = 0 and 0.25 and at the trailing edge of the contact for 0.4 and 0.5,
beside Hamilton's closed form, and what the search finds on the largest grid:
END
table stress_edge-1
claim "The closed form has the published figures, to their four digits." stress_edge-1 1 'abs($c["closed_form"] - $c["published"]) <= 5.1e-5'
claim "Below the surface the search finds them within 0.25 (h/a)² + 2e-6 of 128 cells." stress_edge-1 '$c["mu"] < 0.3' 'abs($c["found_error"]) <= 0.25 * (3 / 128) ^ 2 + 2e-6'
text <<'END'
From μ = 0.305 on (ν = 0.3) the largest stress lies at that edge, on the surface:
END
table stress_edge-2
claim "The largest von Mises stress of a sliding contact lies within the error that is stated, at most 2.5 times its own." stress_edge-2 1 'abs($c["found"]) <= $c["stated"] && $c["stated"] <= 2.5 * abs($c["found"])'
claim "It is too small on every grid." stress_edge-2 1 '$c["found"] < 0'
text <<'END'
The stress rises to the edge as the root of the distance, but in front of it is nearly level: a coarse grid finds the level, 4 or
7 % too little, and so does one twice as coarse. The two agree within 0.3 % where 4 % is missing. So the difference between two
grids is no measure of this error, and extrapolation at order one half, which presumes that both grids see the rise, does not
remove it. What does tell is the closed form: the stress at the edge of a sphere, or of a cylinder, with the largest pressure
that was found. The stated error is what is missing to it, and 1.5 % of that pressure.

The largest tension, at the same edge:
END
table stress_edge-3
claim "With friction the largest tension is too small, and lies within the error that is stated, at most 2.5 times its own." stress_edge-3 '$c["mu"] > 0' '$c["found"] < 0 && -$c["found"] <= $c["stated"] && $c["stated"] <= -2.5 * $c["found"]'
claim "At rest it is too small by at most 1.3 cells over the radius." stress_edge-3 '$c["mu"] == 0' '$c["found"] < 0 && -$c["found"] <= 1.3 * 3 / $c["n"]'
text <<'END'
With friction its error falls as the root of the cell. At rest it halves with the cell: the largest tension stands at the edge of
the contact, and the centres of the cells lie beside it.
END
