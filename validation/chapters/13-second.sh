heading "A second code"
run_script second /usr/bin/python3 validation/independent/compare
text <<'END'
Some hundred lines of Python (`validation/independent/`) that share nothing with Asperity: Polonsky's and Keer's conjugate gradients
by numpy, and the stresses of Boussinesq's and Cerruti's point loads, integrated over each cell by Gauss's rule. Differences in the
largest pressure and in the range of displacements, at a residual of 1e-12; stresses at twelve random points one to twelve cells
deep, with a friction of 0.3. Of a load that repeats no sum is the stress.
END
table second-1
claim "A second code finds the pressures to 1e-9 of the largest, and the stresses to 1e-13." second-1 1 \
  '$c["pressure"] <= 1e-9 && ($c["stress"] == "-" ? 0 : $c["stress"]) <= 1e-13'
