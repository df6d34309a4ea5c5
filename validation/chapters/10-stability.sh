heading "Stability"
run stability

text <<'END'
Stiff and extreme cases, stage by stage: what makes each one hard, and its outcome. A case with an answer has an error and a bound; a
case without an answer is refused, with the name of the option or variable. No case ends in a crash, in NaN, or in silence.
END
for stage in kernel surface marginal statistics contact stress; do
  text <<<"**${stage^}**"
  table stability-1 '$c["stage"] == "'$stage'"' case hard outcome measure figure bound
done
claim "Every case with an answer keeps its bound, and every other case is refused." stability-1 1 '$c["holds"] == "yes"'

text <<'END'
Targets that have no kernel, or barely one, and the answer: exact, a wider kernel, the nearest feasible autocorrelation, or a
refusal. The rows `least-squares` show what a kernel of the same lags achieves at best; no tool offers it.
END
table acf_error_time-3 1 case difficulty infeasible outcome residual error kernel seconds
claim "Every extreme target called exact or wider has a residual of at most 1e-10." acf_error_time-3 \
  '$c["outcome"] == "exact" || $c["outcome"] == "wider"' '$c["residual"] <= 1e-10'
text <<'END'
If its spectrum shows that a target is infeasible, it is refused before any iteration; the residual would show it only after a
thousand. A target cut at 10 % has no kernel of its own size from 17 × 14 lags on, and Newton's iteration finds none from 13 × 13 lags on;
but there is an exact one four times as wide.

Round-off of the stress, against long double: elongated cells, depths far from the cell size, pressures over twelve decades.
END
table stress_error_time-3
claim "Round-off stays below 1e-15 of the largest pressure, for all cells, depths and decades." stress_error_time-3 1 '$c["error_over_pressure"] <= 1e-15'
text <<'END'
Relative to the stress itself, accuracy falls with the square of depth: the stress of a single cell is the small difference of its
corner terms. The stress of a contact, a sum over many cells, is not so small.
END
