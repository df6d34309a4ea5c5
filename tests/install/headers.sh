#!/usr/bin/env bash
set -euo pipefail
rm -rf "$1" && mkdir -p "$1"
cd "$prefix/include/asperity"
find . -name '*.hpp' -printf '#include "%P"\n' | sort >"$1/all.cpp"
[ "$(wc -l <"$1/all.cpp")" -gt 50 ]
if grep -rnE '#include <' . | grep -vE '<([a-z_]+|Eigen/[A-Za-z]+|unistd.h|sys/mman.h)>'; then
  echo "a foreign header is included" >&2; exit 1
fi
PKG_CONFIG_PATH="$prefix/$libdir/pkgconfig"; export PKG_CONFIG_PATH
"$CXX" -std=c++20 -fsyntax-only -Wall -Wextra -Werror $(pkg-config --cflags asperity) "$1/all.cpp"
