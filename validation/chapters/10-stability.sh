heading "Stability"
run stability

text <<'END'
Stiff and extreme cases, stage by stage: what makes each of them hard, and how it ends. What has an answer is judged by a
figure and its bound; what has none is refused by the name of the option or of the variable. No case ends in a crash, in a
number that is none, or in silence.
END
for stage in kernel surface marginal statistics contact stress; do
  text <<<"**${stage^}**"
  table stability-1 '$c["stage"] == "'$stage'"' case hard outcome measure figure bound
done
claim "Every case that has an answer keeps its bound, and every other is refused." stability-1 1 '$c["holds"] == "yes"'

text <<'END'
Targets that have no kernel, or hardly one, and what is answered: exactly, by a wider kernel, by the nearest autocorrelation
that exists, by least squares, or not at all.
END
table acf_error_time-3 1 case difficulty infeasible outcome residual error kernel seconds
claim "No extreme target is answered without a residual, or with one above 1e-10 as exact." acf_error_time-3 \
  '$c["outcome"] == "exact" || $c["outcome"] == "wider"' '$c["residual"] <= 1e-10'
text <<'END'
A target is refused before any iteration where its spectrum says so: a residual would have told only after a thousand.
A cut at 10 % has no kernel of its own size from 17 × 14 lags on, and an exact one four times as wide.

Round-off of the stress: flat cells, depths far from the cells' size, pressures over twelve decades, against long double.
END
table stress_error_time-3
claim "Round-off stays below 1e-15 of the largest pressure, whatever the cells, the depth and the decades." stress_error_time-3 1 '$c["error_over_pressure"] <= 1e-15'
text <<'END'
Relative to the stress itself, digits go with depth, as the square of it: the stress of a single cell is the small rest of its
corners. The stress of a contact, a sum over many cells, is not so small.
END
