heading "What a scene does not need"
run scene_time "$(size 64 256)"

text <<'END'
The same scene with a part left out, seconds of each part, and its share of the whole:
END
table scene_time-1
text <<'END'
What is left out is not paid for, to the last part: no kernel and no noise without roughness, one component for one, a plane
for a plane. A limit pressure makes the contact dearer by a third, which then has two kinds of cells to find. Without padding a
periodic stress costs half; its contact, which has no edge and is spread over the whole domain, does not become cheaper. The
search for the maximum costs about as much as the 32 layers of the volume, and finds what lies between them.
END
