heading "Twins of maps"
run_script twins validation/twins $(size quick "")

text <<'END'
`asperity-generate --like MAP` draws surfaces of the size and spacing of a map, with the autocorrelation of the map under a window.
Maps of six models, Sq 0.4 µm: square, 256 × 256 points of 17 correlation lengths (eight of the roll-off of self-affine); oblong,
512 × 128 points of unequal spacing, 40 × 17 lengths; periodic; and masked, a square without two discs and a hundredth of the points.
Each has four twins. Sq, Sdq, density and mean curvature of summits are ratios of the twins to their map, means over the maps;
`sampling` is the standard error that the window leaves in the ratio of Sdq, derived at the top of `validation/twins`. `area` is that
of contact with a steel ball of 20 mm, over the area of new surfaces of the model, which differ among themselves by `spread`; `off` is
the difference over that.
END
table twins-1
claim "Twins have the rms slope of their maps within 5 %." twins-1 1 'abs($c["Sdq"] - 1) <= 0.05'
claim "They have the density and the curvature of its summits within a factor of 1.3." twins-1 1 \
  '$c["summits"] <= 1.3 && $c["curvature"] <= 1.3 && 1 / $c["summits"] <= 1.3 && 1 / $c["curvature"] <= 1.3'
claim "Their mean area of contact with a ball lies within the standard deviation between surfaces of the model." twins-1 1 \
  'abs($c["off"]) <= 1'
text <<'END'
Before, twins came from the biased estimate of the autocorrelation, which has a cusp at lag zero, and from equations solved by KINSOL.
The same maps of the Gaussian model both ways:
END
table twins-2
text <<'END'
The cusp is a little of an exponential: it adds to the slopes, multiplies the summits, and takes from the area of contact.

One twin of a map in a file of N × N points, written to a file; `fields` is the peak memory beyond that of a small map, in fields of
N × N doubles:
END
table twins-3
claim "A twin takes at most a second of the processor from a map of 650 × 650 points, five of 2048 × 2048." twins-3 1 \
  '$c["processor"] <= $c["limit"]'
text <<'END'
Six fields is what the largest map takes; in a small one the work space of the transforms counts too.
END
text <<'END'
Two measured maps (`tests/data`), levelled, and eight twins of each, under a steel ball. Bars are the standard deviation between twins:
END
picture twins "Measured maps (lines) and eight twins of each (points) under a ball: contact area and mean gap" <<'END'
set xlabel 'load / largest load'
set multiplot layout 1,2
name = 'afm-64x48 profiler-96x96'
of(k, c) = strcol(1) eq word(name, k) ? column(c) : NaN
set bars 0.7
set ylabel 'contact area [m²]'
set key inside bottom right samplen 1
plot for [k=1:2] '@twins-4.tsv' using 2:(of(k, 3)) with lines linetype k title word('AFM profiler', k), \
     for [k=1:2] '' using 2:(of(k, 4)):(of(k, 5)) with yerrorbars linetype k pointtype 6 notitle
set ylabel 'mean gap [m]'
set yrange [3e-8:4e-6]
unset key
plot for [k=1:2] '@twins-4.tsv' using 2:(of(k, 6)) with lines linetype k, \
     for [k=1:2] '' using 2:(of(k, 7)):(of(k, 8)) with yerrorbars linetype k pointtype 6
unset multiplot
END
table twins-4
text <<'END'
A twin has the spectrum of scratches, feed marks and steps, not these themselves, and its tops lie elsewhere: under the smallest load
the AFM map touches with some six cells, and which ones is chance. Under every load it has 1.4 to 1.9 times the area of its twins,
more than their deviation; why, one ball at one place does not tell. The profiler's twins have twice the summits of the map, where
those of the six models have the map's within a few per cent: its heights are not Gaussian, and it is few correlation lengths wide.
`asperity-stats MAP TWIN... --compare` says in what a map differs from its twins, here from the same; z is the difference in standard
errors:
END
table twins-5
