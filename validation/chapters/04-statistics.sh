heading "Statistics"
run moments_error_time "$(size 128 2048)"
run statistics_coverage "$(size 50 400)"

text <<'END'
Digits of the moments of a 1 nm roughness that stands on an offset, against a sum in long double; points on a line are
offsets of 0, 1 µm, 1 mm and 1 m.
END
picture moments "Error of the kurtosis against seconds" <<'END'
set ylabel 'relative error of Sku'
set yrange [1e-17:1e2]
ways = "asperity gsl naive"
sizes = "128x128 512x512 2048x2048"
plot for [i=1:3] for [n=1:3] '@moments_error_time-1.tsv' \
  using 8:(strcol(1) eq word(ways, i) && strcol(2) eq word(sizes, n) ? 10**(-$7) : NaN) \
  with linespoints linetype i pointtype int(word('7 6 4', n)) title word(ways, i).', '.word(sizes, n)
END
table moments_error_time-1
claim "The moments have thirteen digits whatever the offset." moments_error_time-1 '$c["way"] == "asperity"' \
  'least(least($c["digits_Sa"], $c["Sq"]), least($c["Ssk"], $c["Sku"])) >= 13'
text <<'END'
GSL's recurrences in long double start from a mean that was rounded to double, and so lose a digit of skewness for each
that the offset has over the roughness; two passes about a shifted origin lose none, and take less than a tenth of the
time. A kurtosis from raw sums has three digits left at an offset of a thousand times the roughness and none at a million
times, and does not say so; it is not even faster on a large surface.

Coverage of the 95 % intervals, in per cent of all fields, with the correlation known and with the one that the field
itself shows:
END
table statistics_coverage-1
# 95 - 4 √(95 · 5 / fields) per cent.
claim "The moments' intervals cover 95 % within four standard errors of the count, or more." statistics_coverage-1 1 \
  'least($c["mean"], least(least($c["Sa"], $c["Sq"]), least($c["Ssk"], $c["Sku"]))) >= '"$(size 82.6 90.6)"
text <<'END'
Neighbours are correlated, and N_eff, not N, says what a field is worth: from 150 on the intervals cover what they
should, and nearly so at 41, a field of four correlation lengths by four. Intervals that count all points as
independent, at a width of 16, would be ten times too short.

The same of correlation lengths, Sal and those along x at 1/e and 10 %, with the intervals that lie wholly below and above
the truth:
END
table statistics_coverage-2
claim "So do those of lengths." statistics_coverage-2 1 \
  'least($c["Sal"], least($c["e"], $c["tenth"])) >= '"$(size 82.6 90.6)"
text <<'END'
An interval's ends are taken where the correlation strays from the level by 1.96 errors of that end's own lag. With the
error at the length found, and the same for both ends, a fifth to a tenth of the intervals of a field of few correlation
lengths would lie wholly below the truth. Where the upper side never falls to the level there is no upper end, and such an
interval misses on one side only.

False alarms of `asperity-validate`, in per cent, at a stated 1 and 5 %; and the cost of the statistics in real transforms of
the same size:
END
table statistics_coverage-3
# 1 + 4 √(1 · 99 / fields), 5 + 4 √(5 · 95 / fields) per cent.
claim "False alarms are as rare as stated, within four standard errors of the count." statistics_coverage-3 1 \
 '$c["at_1"] <= '"$(size 6.7 3)"' && $c["at_5"] <= '"$(size 17.4 9.4)"
table statistics_coverage-4
text <<'END'
The autocorrelation needs a padded transform there and back, some four times a transform of the field alone; how much a
field is worth costs as much again, for its sums run over powers of the correlation at all lags.
END
