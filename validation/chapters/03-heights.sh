heading "Heights: Johnson's distributions of a given skewness and kurtosis"
run johnson_plane "$(size 1 50)"

text <<'END'
The plane of skewness and kurtosis, K = Sk² + 1 + a distance: the error of the kurtosis, relative, by another quadrature.
END
picture heights "Error of the kurtosis over the plane" <<'END'
set xlabel 'K - Sk² - 1'
set ylabel 'relative error of K'
set yrange [1e-17:1e-9]
skewness = "0 1e-06 0.01 0.3 1 2 3 5 10 20 50"
set key title 'Sk'
plot for [i=1:words(skewness)] '@johnson_plane-1.tsv' \
  using ($2 - $1 ** 2 - 1):(strcol(3) ne 'refused' && strcol(1) eq word(skewness, i) ? abs($9) + 2e-17 : NaN) \
  with linespoints pointtype 7 title word(skewness, i)
END
table johnson_plane-1 '$c["skewness"] == 0 || $c["skewness"] == 1 || $c["skewness"] == 3 || $c["skewness"] == 10'
claim "Moments are those asked for to 1e-10, or the pair is refused." johnson_plane-1 '$3 != "refused"' \
  '$c["of_skewness"] ^ 2 <= 1e-20 && $c["of_kurtosis"] ^ 2 <= 1e-20'
text <<'END'
Every pair that is not refused is met to round-off, or nearly: the error grows with the kurtosis, since that of a long
tail is made far out. What is refused lies so near to the edge K = Sk² + 1 that all heights are two values. A
transformed height costs about as much as the noise that it is made from; the symmetric and the normal ones less.
END
