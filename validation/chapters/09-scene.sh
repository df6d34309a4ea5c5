heading "What a scene does not need"
run scene_time "$(size 64 256)"

text <<'END'
The same scene with a part left out, seconds of each part, and its share of the whole:
END
table scene_time-1
