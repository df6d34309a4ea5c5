heading "Published results"
run_script published validation/published/run $(size "westergaard full_contact" "")
text <<'END'
Figures of the literature, run by the tools from Python (`validation/published/results.py` cites each): Westergaard's wavy flat, the
egg box of Johnson, Greenwood and Higginson, Sneddon's cone and the square punch, Hertz's ellipses with Johnson's table of shear
stresses, Hamilton's sliding sphere, area and gap of self-affine surfaces, Persson's full contact. `error` is what the tools state
for their figure, or the standard error of a mean over surfaces; `doubt` is that of the published one.
END
table published-1
claim "Every published figure lies within twice the stated errors of both." published-1 1 \
  'abs($c["difference"]) <= 2 * ($c["error"] + $c["doubt"])'
