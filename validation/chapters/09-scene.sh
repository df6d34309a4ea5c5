heading "Cost of each part of a scene"
run scene_time "$(size 64 256)"

text <<'END'
The same scene with one part omitted: seconds of each part, and the share of the whole:
END
table scene_time-1
text <<'END'
Omitted parts cost nothing: no kernel and no noise without roughness, one component for one, a plane for a plane. A limit pressure
makes the contact up to a third more expensive, because there are two kinds of cells to find. A periodic stress needs no padding and
costs half; the periodic contact has no edge, covers the whole domain, and is not cheaper. The search for the maximum costs a
fraction of the 32 layers of the volume, and finds maxima between them.
END
