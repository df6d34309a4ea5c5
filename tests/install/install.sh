#!/usr/bin/env bash
set -euo pipefail
rm -rf "$prefix"
cmake --install "$build" --prefix "$prefix" >/dev/null
[ -x "$prefix/bin/asperity-generate" ] && [ -f "$prefix/include/asperity/core/field.hpp" ]
[ -s "$prefix/lib/python3/dist-packages/asperity/stage.pyi" ]  # of which a type checker would not say that it is missing
