#!/usr/bin/env bash
set -euo pipefail
same() { [ "$2" = "$version" ] || { echo "$1 says $2, the project is $version" >&2; exit 1; }; }
for tool in "$prefix"/bin/asperity-*; do same "$tool" "$("$tool" --version | grep -oE '[0-9]+(\.[0-9]+)+' | head -1)"; done
same asperity.pc "$(PKG_CONFIG_PATH="$prefix/$libdir/pkgconfig" pkg-config --modversion asperity)"
same asperity.__version__ "$(sed -n 's/^__version__ = "\(.*\)"/\1/p' "$prefix"/lib/python3/dist-packages/asperity/__init__.py)"
same CITATION.cff "$(sed -n 's/^version: //p' "$source/CITATION.cff")"

rm -rf "$1" && mkdir -p "$1"
cat >"$1/find.cmake" <<'CMAKE'
find_package(Asperity ${wanted} CONFIG QUIET PATHS ${folder} NO_DEFAULT_PATH)
if(NOT Asperity_FOUND)
  message(FATAL_ERROR "${Asperity_CONSIDERED_VERSIONS}")
endif()
CMAKE
IFS=. read -r major minor _ <<<"$version"
if other=$(cmake -Dwanted="$major.$((minor + 1))" -Dfolder="$prefix/$libdir/cmake/Asperity" -P "$1/find.cmake" 2>&1); then
  echo "a later minor version was found" >&2; exit 1
fi
same AsperityConfigVersion.cmake "$(grep -oE '[0-9]+\.[0-9]+\.[0-9]+' <<<"$other")"
