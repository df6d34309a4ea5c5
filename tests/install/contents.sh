#!/usr/bin/env bash
# Except the licence and the changes, which Debian requires of each package.
set -euo pipefail
rm -rf "$1" && mkdir -p "$1"
(cd "$prefix" && find . ! -type d) | sort >"$1/installed"
for package in "$packages"/*.deb; do dpkg-deb -c "$package"; done | grep -v '^d' | sed 's/ -> .*//; s|.* ./usr|.|' |
  grep -vE '/(copyright|changelog.Debian.gz)$' | sort >"$1/packed"
diff "$1/installed" "$1/packed"
