heading "The study of 2009 again"
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
Creţu, Bălan and Urzică pressed two spheres together, one of them rough, and asked what the lengths of the autocorrelation
change when the height moments stay as they are. Here are their cases, n × m lags with the exponential autocorrelation cut
where it has fallen to 1 % or to 10 %, over many seeds instead of one, each mean with its standard error. First the
surfaces; lengths in samples of 23.4 µm, Sq in µm:
END
table paper_study-1 '$c["lags"] != "smooth"' cut lags answer Sq Sq_se Ssk Ssk_se Sku Sku_se length_x length_x_se length_y length_y_se
text <<'END'
Then their contacts: real area in mm², the share of it at the limit pressure, the largest von Mises stress anywhere and its
depth, and the largest two cells below the surface, in MPa and µm:
END
table paper_study-1 1 cut lags p_max area area_se plastic plastic_se von_mises von_mises_se depth depth_se near near_se
text <<'END'
**Finding: stresses near the surface are far above those of the smooth contact.** By how many times, two cells deep, where
cells do not show any more:
END
table paper_study-2 '$c["finding"] == "near-surface"' cut lags mean se bound p verdict
claim "Two cells below the surface the largest stress of every case is more than 1.5 times that of the smooth contact." \
  paper_study-2 '$c["finding"] == "near-surface"' '$c["p"] < '"$(size 0.05 0.01)"
claim "The largest stress of all lies above half the depth of the smooth contact's in every case." \
  paper_study-2 '$c["finding"] == "shallower"' '$c["p"] < 0.01'
text <<'END'
**Finding: the autocorrelation lengths change the stress state.** The difference of two cases, drawn from the same noise:
END
table paper_study-2 '$c["finding"] == "changed"' cut lags against quantity mean se p verdict
claim "Lengths change the real area and the plastic share of it, in every pair of cases." paper_study-2 \
  '$c["finding"] == "changed" && ($c["quantity"] == "area" || $c["quantity"] == "plastic")' '$c["p"] < 0.01'
claim "They change the largest von Mises stress, from 3 × 3 lags to 17 × 14." paper_study-2 \
  '$c["quantity"] == "von_mises" && $c["against"] == "3x3" && $c["lags"] == "17x14"' '$c["p"] < 0.01'
text <<'END'
Longer waves make a larger area, less of it plastic, and smaller largest stresses: at the same height slopes are lower.
That the depth of the largest stress changes is not shown, and cannot be: it is a third of a cell in every case, for an
exponential autocorrelation has no smallest wave, and the cells set the depth of its sharpest peaks.

**Finding: the height moments stay as they are.** The same pairs; Sq relative to 0.4 µm:
END
table paper_study-2 '$c["finding"] == "same"' cut lags against quantity mean se bound p verdict
claim "Between the cases Sq differs by less than 5 %, Ssk and Sku by less than 0.1." paper_study-2 \
  '$c["finding"] == "same"'"$(size ' && $c["lags"] == "7x4"' '')" '$c["p"] < 0.01'
text <<'END'
What is left of a difference in Sq is no accident: heights are counted from the surface's own mean, which follows long
waves and takes S₁/2N of Sq away, 0.9 % at 17 × 14 lags cut at 10 %.

**Its figures**: the smooth spheres, and two of the cases under both cuts, drawn from one noise and scaled to 0.4 µm rms. First
the noise, which looks the same wherever one looks:
END
shown paper-noise "White noise, seed 7"
text <<'END'
The surfaces: ridges along x where the lengths differ, hills as wide as long where they do not; cut at 1 %, at half the lengths,
finer ones of the same height.
END
shown paper-surface "Surfaces, heights 200 times enlarged"
text <<'END'
Their distributions of height, which cannot be told apart from the Gaussian nor, but for the width of their errors, from one
another; longer waves leave fewer independent heights.
END
shown paper-pdf "Distributions of height with twice their standard errors"
text <<'END'
Profiles through the middle, where the cases can be told only by how fast they change:
END
shown paper-profiles "Profiles along x and y"
text <<'END'
The autocorrelations prescribed and estimated: within twice their errors up to the last lag prescribed. Cut at 10 %, that is
375 µm along x and 70 µm along y, or 281 µm, and beyond it the surface falls off faster than the exponential.
END
shown paper-acf "Autocorrelation along x and y, of the surface and of the target without its cut"
text <<'END'
Pressure: what was a smooth cap stands on ridges or hills that reach the limit, and leaves hollows between them empty.
END
shown paper-pressure "Contact pressure"
text <<'END'
Real area, and the part of it at the limit pressure: the shorter the waves, the smaller the one and the larger the other.
END
shown paper-contact "Contact area, elastic and at the limit pressure"
text <<'END'
The von Mises stress in the vertical section through its maximum: there is one below each asperity that touches, some 9 µm
deep and, below the worst, higher than the one that all of them share below the middle of the contact. The worst stands
anywhere, and a section far from the middle misses what is below it.
END
shown paper-von-mises "Von Mises stress, section through the maximum"
shown paper-von-mises-surface "The same, the upper 0.2 mm"
text <<'END'
In the middle section only what is above 0.6 p₀: below roughness this zone is Hertz's still, at his depth; its size changes
from one surface to the next.
END
shown paper-von-mises-detail "Von Mises stress above 0.6 p0, section through the middle"
