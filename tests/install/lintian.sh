#!/usr/bin/env bash
set -euo pipefail
command -v lintian >/dev/null || { echo "SKIPPED: lintian is not installed"; exit 77; }
lintian --fail-on error "$packages"/*.deb
