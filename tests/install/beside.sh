#!/usr/bin/env bash
# As in the wheel. Those of the system are another test's.
set -euo pipefail
rm -rf "$1" && cp -a "$prefix" "$1"
library=$(dirname "$(find "$1" -name 'libasperity_io.so' -o -name libasperity_io.a | head -1)")
[ -f "$library/libasperity_io.so" ] || exit 77
export PATH="$1/bin:$PATH"
make() { asperity-generate --shape 16x16 --size 1mm --rq 0.4um --model gaussian --length 60um --seed 7 -o "$1/$2"; }
make "$1" map.nc
mkdir "$library/udunits" "$library/gnuplot"
echo '<unit-system></unit-system>' >"$library/udunits/udunits2.xml"
if make "$1" none.nc 2>"$1/said"; then echo "units were read from elsewhere" >&2; exit 1; fi
UDUNITS2_XML_PATH=/usr/share/xml/udunits/udunits2.xml make "$1" again.nc
rm -r "$library/udunits"
printf '#!/bin/sh\ncat >/dev/null\necho drawn by its own\n' >"$library/gnuplot/gnuplot"
chmod +x "$library/gnuplot/gnuplot"
asperity-plot "$1/map.nc" --kind surface -o "$1/map.png"
grep -q '^drawn by its own$' "$1/map.png"
