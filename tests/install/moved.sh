#!/usr/bin/env bash
# The chain of the tools, with only PATH in the environment.
set -euo pipefail
rm -rf "$1" && cp -a "$prefix" "$1"
cd "$1"
left=$(readelf -d bin/asperity-* $(find . -name 'lib*.so.*') | grep -F "$build" || true; grep -rIlF -e "$build" -e "$prefix" . || true)
[ -z "$left" ] || { echo "paths of this machine are left: $left" >&2; exit 1; }
env -i PATH="$1/bin:/usr/bin:/bin" bash -euo pipefail -c '
  asperity-generate --shape 64x64 --size 1mm --rq 0.4um --length 60um --seed 7 | asperity-stats --json' >stats.json
grep -q '"Sq"\|"sq"' stats.json
# What is loaded when it is needed is found too.
env -i PATH="$1/bin:/usr/bin:/bin" bash -euo pipefail -c '
  asperity-stats '"$source"'/tests/corpus/netcdf4/whole
  asperity-generate --shape 16x16 --size 1mm --rq 0.4um --length 60um --seed 7 | asperity-convert -o moved.x3p
  asperity-convert moved.x3p -o moved.nc' >/dev/null
