#!/usr/bin/env bash
# The readers' libraries are asperity_io's. A static library has no list of what it needs.
set -euo pipefail
library=$prefix/$libdir/libasperity.so
[ -f "$library" ] || exit 77
needed=$(readelf -d "$library" | grep NEEDED)
grep -q fftw3 <<<"$needed"
if grep -E 'netcdf|libzip|pugixml|udunits|libmd|libz\.' <<<"$needed"; then exit 1; fi
