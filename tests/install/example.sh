#!/usr/bin/env bash
set -euo pipefail
rm -rf "$1"
cmake -S "$source/examples/uses-asperity" -B "$1" -DCMAKE_PREFIX_PATH="$prefix" -DCMAKE_CXX_COMPILER="$CXX" >/dev/null
cmake --build "$1"
"$1/contact-area" | tee "$1/out"
grep -qE '^contact area 0\.[0-9]+ .* standard error 0\.0[0-9]*[1-9]' "$1/out"
