#!/usr/bin/env bash
# Only asperity_io links the libraries of the readers. Modules, which are loaded when they are needed, alone link those of
# NetCDF-4 and zip, whose forty libraries took half of the time in which a tool starts, and FFTW in single precision. A static
# library has no list of dependencies.
set -euo pipefail
library=$prefix/$libdir/libasperity.so
[ -f "$library" ] || exit 77
needed() { readelf -d "$1" | grep NEEDED; }
needed "$library" | grep -q fftw3
if needed "$library" | grep -E 'netcdf|libzip|pugixml|udunits|libz\.'; then exit 1; fi
loaded=$(ldd "$prefix/bin/asperity-stats")
grep -q libasperity_io <<<"$loaded"
if grep -E 'netcdf|hdf5|libzip|crypto|curl|fftw3f' <<<"$loaded"; then exit 1; fi
