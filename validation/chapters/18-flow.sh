heading "Flow: plastic strain below the contact"
run flow_error_time "$(size 21 41)"

text <<'END'
A perfectly plastic sphere, σ_Y/E' = 0.003, pressed against a rigid flat to ω* times the approach at which it yields, beside the fits
of finite elements by Kogut & Etsion (`ke`), Jackson & Green (`jg`) and, of the dent that stays, Etsion, Kligerman & Kadin
(`ekk`). `cut` is a contact of the same approach whose pressure is limited to 3 σ_Y. `mises` is the largest von Mises
stress over σ_Y.
END
table flow_error_time-1
claim "Load and area of the sphere are within 5 % of both fits up to 20 times the approach of first yield." flow_error_time-1 \
  '$c["approach"] <= 20' 'abs($c["load"]/$c["load_ke"] - 1) < 0.05 && abs($c["load"]/$c["load_jg"] - 1) < 0.05 && abs($c["area"]/$c["area_ke"] - 1) < 0.05'
claim "Von Mises' stress exceeds the yield stress by at most 2e-4." flow_error_time-1 1 '$c["mises"] <= 1.0002'
text <<'END'
The fits differ from each other by as much as from the flow. The limit pressure overstates the load at a given approach: a
pressure of 3 σ_Y is reached only at large ω*.

Error against time at ω* = 6, by cells a side, layers and increments of the load; the reference is the last row of each kind:
END
table flow_error_time-2
text <<'END'
Increments count most, and their error falls as one over their number; the default halves them to see it. Layers and cells
matter at the largest pressure alone.
END
