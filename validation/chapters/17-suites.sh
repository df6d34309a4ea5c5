heading "Tests of other projects"
run_script suites validation/suites/run ${SUITES:+--files "$SUITES"}
text <<'END'
What the tests of other projects expect, computed by the tools from the same heights (`validation/suites/`: `scenes.tsv` has the
commands, `figures.tsv` the figures, each with its tolerance and where it comes from). Where a test compares with a closed form, its
value is the figure. Files of the projects are not in this tree: with them, in folders named as the projects,
`SUITES=FOLDER validation/report` runs all scenes.

An egg box, pillars with bumps and dips, hills on a hill, a random surface and an AFM map (`tests/data/afm-64x64.nc`) were given to
surfalize and to Gwyddion's library too. Neither prunes hills, so that Spd to Sdv of ISO 25178-2 stand beside numpy's alone, by steepest
ascent and Wolf pruning as it is worded. Gwyddion compares a point with four neighbours: on the AFM map it finds twice as many peaks.
Where heights are equal, as on the egg box, the core may begin at several places: the first counts (ISO 13565-2).
END
table suites-2
text <<'END'
`tolerance` is the project's, or half the last digit that it prints and what its solver leaves; `error` is what the tools state for
their figure, in contacts with the error of the grid. `off` is the difference over both. CONTACT's cases are on its own grids, cell by
cell, so that no error of a grid remains. It has friction; where the two bodies are alike that does not act on the pressure.
END
claim "Every figure of another project's tests agrees with the tools', but for those that we compute otherwise." suites-1 \
  '$c["ours"] == "-"' '$c["off"] <= 1'
text <<'END'
These figures differ. `ours` is our own computation from the same heights, by numpy alone (`validation/suites/own.py`); `because` says
what the project does otherwise.
END
table suites-1 '$c["agrees"] == "no"' project scene quantity unit expected here ours because
claim "Where a figure differs, the tools have what numpy computes from the same heights." suites-1 '$c["ours"] != "-"' '$c["off"] <= 1'
text <<'END'
Not compared, for want of data:

* the Contact Mechanics Challenge (Müser and others, Tribol. Lett. 65 (2017) 118). Its surface is a file of 17 to 257 MB of the Universität
  des Saarlandes. SurfaceTopography's copy of 2048 × 2048 points is not in the snapshots of that project that could be had. Its reference
  results have adhesion, which the tools lack.
* the type F1 profiles of NPL and NIST (softgauges, SMATS). Formats and programs are described; the profiles are in no archive that could be
  had. Todhunter, Leach, Lawes and Blateyron (Meas. Sci. Technol. 28 (2017) 065017) print the parameters of 17 of them.
* Tamaas, whose repository could not be had.
END
for project in $(rows suites-2 | awk -F'\t' 'NR > 1 { print $1 }'); do
  heading "$project"
  table suites-1 "\$c[\"project\"] == \"$project\" && \$c[\"agrees\"] == \"yes\"" scene quantity unit expected tolerance here error off
done
