#!/usr/bin/env bash
set -euo pipefail
rm -rf "$packages"
cpack --config "$build/CPackConfig.cmake" -G DEB -B "$packages" >/dev/null
[ "$(ls "$packages"/*.deb | wc -l)" -eq 5 ]
