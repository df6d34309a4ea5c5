#!/usr/bin/env bash
# Only asperity_io links the libraries of the readers. A static library has no list of dependencies.
set -euo pipefail
library=$prefix/$libdir/libasperity.so
[ -f "$library" ] || exit 77
needed=$(readelf -d "$library" | grep NEEDED)
grep -q fftw3 <<<"$needed"
if grep -E 'netcdf|libzip|pugixml|udunits|libmd|libz\.' <<<"$needed"; then exit 1; fi
