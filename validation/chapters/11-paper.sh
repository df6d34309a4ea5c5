heading "The study of 2009 again"
run paper_study "$(size 5 50)"

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
END
