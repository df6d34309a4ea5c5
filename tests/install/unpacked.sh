#!/usr/bin/env bash
set -euo pipefail
rm -rf "$1" && mkdir -p "$1"
for package in "$packages"/*.deb; do dpkg-deb -x "$package" "$1"; done
env -i PATH="$1/usr/bin:/usr/bin:/bin" bash -euo pipefail -c '
  asperity-generate --shape 64x64 --size 1mm --rq 0.4um --length 60um --seed 7 |
    asperity-contact --radius 50mm --young 208GPa --poisson 0.3 --load 50N | asperity-stress --maximum >'"$1/stressed.nc"
[ -s "$1/stressed.nc" ]
/usr/bin/python3 -c 'import xarray' 2>/dev/null || exit 0  # the module's need
env -i PATH="$1/usr/bin:/usr/bin:/bin" PYTHONPATH="$1/usr/lib/python3/dist-packages" /usr/bin/python3 -B -c '
import asperity
print(asperity.stats(asperity.generate(shape=(64, 64), size="1mm", rq="0.4um", length="60um", seed=7)).loc["Sq"])'
