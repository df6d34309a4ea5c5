#!/usr/bin/env bash
# Copies under a launcher would write one file.
set -euo pipefail
rm -rf "$1" && cp -a "$prefix" "$1"
rm "$1/$libdir"/libasperity_mpi.*
tool="$1/bin/asperity-contact --smooth --shape 16x16 --size 1mm --radius 10mm --young 208GPa --poisson 0.3 --load 1N"
status=0
OMPI_COMM_WORLD_SIZE=3 $tool -o "$1/smooth.nc" 2>"$1/said" || status=$?
[ "$status" -eq 4 ] && [ ! -e "$1/smooth.nc" ]
[ "$(wc -l <"$1/said")" -eq 1 ] && grep -q '3 copies were started.*install asperity-mpi' "$1/said"
$tool -o "$1/smooth.nc"
