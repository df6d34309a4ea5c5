#!/usr/bin/env bash
set -euo pipefail
rm -rf "$1" && mkdir -p "$1"
cd "$source/examples/uses-asperity"
export PKG_CONFIG_PATH="$prefix/$libdir/pkgconfig"
"$CXX" -std=c++20 -O2 contact_area.cpp -o "$1/contact-area" $(pkg-config --cflags --libs asperity)
LD_LIBRARY_PATH="$prefix/$libdir" "$1/contact-area" | tee "$1/out"
grep -qE '^contact area 0\.[0-9]+ .* standard error 0\.0[0-9]*[1-9]' "$1/out"
