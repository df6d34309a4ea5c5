#!/usr/bin/env bash
set -euo pipefail
rm -rf "$prefix"
cmake --install "$build" --prefix "$prefix" >/dev/null
[ -x "$prefix/bin/asperity-generate" ] && [ -f "$prefix/include/asperity/core/field.hpp" ]
