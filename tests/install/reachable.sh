#!/usr/bin/env bash
# A user of the library can do what the tools do.
set -euo pipefail
cd "$source"
missing=$(grep -rhoE '#include "[^"]+"' tools | cut -d'"' -f2 | sort -u | while read -r header; do
  if [ -f "lib/$header" ] || [[ $header == stats/* ]]; then
    [ -f "$prefix/include/asperity/$header" ] || echo "$header"
  fi
done)
[ -z "$missing" ] || { echo "not installed: $missing" >&2; exit 1; }
