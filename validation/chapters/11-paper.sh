heading "The study of 2009, repeated"
run paper_study "$(size 5 50)"

# The study's figures by the tools, as ./demo draws them: results/paper-*.png.
draw_study() (
  . validation/study.sh
  PATH="$PWD/build/bin:$PATH"
  pictures=$(realpath "$results")
  datasets=$(mktemp -d)
  trap 'rm -r "$datasets"' EXIT
  cd "$datasets"
  smooth smooth
  rough 17x4-10 --lags 17x4 --length 17px,4px
  rough 13x13-10 --lags 13x13 --length 13px,13px
  rough 17x4-1 --lags 17x4 --length 8.5px,2px
  rough 13x13-1 --lags 13x13 --length 6.5px,6.5px
  figures "smooth,17 × 4 to 10 %,13 × 13 to 10 %,17 × 4 to 1 %,13 × 13 to 1 %" smooth {17x4,13x13}-10 {17x4,13x13}-1
  for figure in *.png; do mv "$figure" "$pictures/paper-$figure"; done
)
! wanted paper_study || draw_study

text <<'END'
Creţu, Bălan and Urzică pressed two spheres together, one of them rough, and asked what the correlation lengths change while the
height moments stay the same. Here are their cases: n × m lags, with the exponential autocorrelation cut where it falls to 1 % or
to 10 %, over many seeds instead of one, each mean with its standard error. First the surfaces; lengths in samples of 23.4 µm,
Sq in µm:
END
table paper_study-1 '$c["lags"] != "smooth"' cut lags answer Sq Sq_se Ssk Ssk_se Sku Sku_se length_x length_x_se length_y length_y_se
text <<'END'
Then the contacts: real area in mm², its share at the limit pressure, the largest von Mises stress anywhere and its depth, and the
largest two cells below the surface, in MPa and µm:
END
table paper_study-1 1 cut lags p_max area area_se plastic plastic_se von_mises von_mises_se depth depth_se near near_se
text <<'END'
**Finding: stresses near the surface are far above those of the smooth contact.** The ratio at a depth of two cells, where single
cells have no effect any more:
END
table paper_study-2 '$c["finding"] == "near-surface"' cut lags mean se bound p verdict
claim "Two cells below the surface the largest stress of every case is more than 1.5 times that of the smooth contact." \
  paper_study-2 '$c["finding"] == "near-surface"' '$c["p"] < '"$(size 0.05 0.01)"
claim "In every case the largest stress lies at less than half the depth of the smooth contact's." \
  paper_study-2 '$c["finding"] == "shallower"' '$c["p"] < 0.01'
text <<'END'
**Finding: the correlation lengths change the stress state.** The difference of two cases drawn from the same noise:
END
table paper_study-2 '$c["finding"] == "changed"' cut lags against quantity mean se p verdict
claim "Lengths change the real area and its plastic share, in every pair of cases." paper_study-2 \
  '$c["finding"] == "changed" && ($c["quantity"] == "area" || $c["quantity"] == "plastic")' '$c["p"] < 0.01'
claim "They change the largest von Mises stress, from 3 × 3 lags to 17 × 14." paper_study-2 \
  '$c["quantity"] == "von_mises" && $c["against"] == "3x3" && $c["lags"] == "17x14"' '$c["p"] < 0.01'
text <<'END'
Longer waves give a larger area, a smaller plastic share, and smaller largest stresses, because slopes are lower at the same height.
These results cannot show a change in the depth of the largest stress: it is a third of a cell in every case. An exponential
autocorrelation has no smallest wave, so the cells determine the depth below its sharpest peaks.

**Finding: the height moments stay the same.** The same pairs; Sq relative to 0.4 µm:
END
table paper_study-2 '$c["finding"] == "same"' cut lags against quantity mean se bound p verdict
claim "Between the cases Sq differs by less than 5 %, Ssk and Sku by less than 0.1." paper_study-2 \
  '$c["finding"] == "same"'"$(size ' && $c["lags"] == "7x4"' '')" '$c["p"] < 0.01'
text <<'END'
The remaining difference in Sq is systematic: heights are measured from the surface's own mean, which follows long waves and
reduces Sq by the share S₁/2N, 0.9 % at 17 × 14 lags cut at 10 %.

**The figures of the paper**: the smooth spheres, and two of the cases with both cuts, drawn from one noise and scaled to 0.4 µm rms.
First the noise, which looks the same everywhere:
END
shown paper-noise "White noise, seed 7"
text <<'END'
The surfaces: ridges along x if the lengths differ, round hills if they are equal; with the cut at 1 %, which halves the lengths,
finer ones of the same height.
END
shown paper-surface "Surfaces, heights 200 times enlarged"
text <<'END'
The height distributions cannot be distinguished from the Gaussian, nor from one another except by the width of their errors; longer
waves leave fewer independent heights.
END
shown paper-pdf "Distributions of height with 95 % intervals"
text <<'END'
Profiles through the middle. The cases differ only in how fast the heights change:
END
shown paper-profiles "Profiles along x and y"
text <<'END'
The prescribed and the estimated autocorrelation agree within twice the standard errors up to the last prescribed lag. With the cut
at 10 % this lag is 375 µm along x and 70 µm along y, or 281 µm; beyond it the surface's autocorrelation falls faster than the exponential.
END
shown paper-acf "Autocorrelation along x and y, of the surface and of the target without its cut"
text <<'END'
Pressure: instead of a smooth cap there are ridges or hills at the limit pressure, and valleys without contact between them.
END
shown paper-pressure "Contact pressure"
text <<'END'
Real area, and its part at the limit pressure: shorter waves reduce the area and enlarge this part.
END
shown paper-contact "Contact area, elastic and at the limit pressure"
text <<'END'
The von Mises stress in the vertical section through its maximum. Each asperity in contact has a local maximum some 9 µm below it;
below the most heavily loaded one it exceeds the common maximum below the middle of the contact. That asperity may be anywhere, and
a section that misses it does not show its stress.
END
shown paper-von-mises "Von Mises stress, section through the maximum"
shown paper-von-mises-surface "The same, the upper 0.2 mm"
text <<'END'
The stress above 0.6 p₀ in the middle section. Below the roughness this zone is still that of Hertz, at the same depth; its size
changes from one surface to the next.
END
shown paper-von-mises-detail "Von Mises stress above 0.6 p0, section through the middle"
