#!/usr/bin/env bash
set -euo pipefail
field() { dpkg-deb -f "$packages"/"$1"_"$version"-1_*.deb "$2"; }
needs() { grep -qE "(^|, )$3( |,|$)" <<<"$(field "$1" "$2")" || { echo "$1: $2 has no $3" >&2; exit 1; }; }
library=libasperity${version%.*}
needs asperity Depends "$library"
needs asperity Depends libc6
needs asperity Recommends gnuplot-nox
for package in libfftw3-double3 libgsl27 libnetcdf19 libsundials-kinsol6 libudunits2-0; do
  needs "$library" Depends "$package"
done
needs libasperity-dev Depends "$library \(= $version-1\)"
needs libasperity-dev Depends libeigen3-dev
needs python3-asperity Depends "asperity \(= $version-1\)"
needs python3-asperity Depends python3-xarray
needs python3-asperity Architecture all
needs asperity-mpi Depends libopenmpi3
needs asperity-mpi Depends openmpi-bin
for package in asperity "$library" libasperity-dev python3-asperity asperity-mpi; do
  for name in Maintainer Section Description; do [ -n "$(field $package $name)" ]; done
done
