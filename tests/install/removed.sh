#!/usr/bin/env bash
# Into a separate root, where dpkg knows no other package. Calls of ldconfig are recorded.
set -euo pipefail
if [ "$(id -u)" -ne 0 ]; then
  command -v fakeroot >/dev/null || { echo "SKIPPED: neither root nor fakeroot"; exit 77; }
  exec fakeroot bash "$0" "$@"
fi
rm -rf "$1" && mkdir -p "$1/var/lib/dpkg"/{info,updates,triggers} "$1/var/bin"
touch "$1/var/lib/dpkg/status" "$1/var/lib/dpkg/available"
printf '#!/bin/sh\necho called >>"%s/var/ldconfig"\n' "$1" >"$1/var/bin/ldconfig"
chmod +x "$1/var/bin/ldconfig"
PATH="$1/var/bin:$PATH:/usr/sbin:/sbin"
files() { (cd "$1" && find . -path ./var -prune -o -print | sort); }
run() {
  dpkg --root="$1" --force-not-root --force-depends --force-script-chrootless --log=/dev/null "${@:2}" \
    >"$1/var/remarks" 2>&1 || { cat "$1/var/remarks" >&2; exit 1; }
}
before=$(files "$1")
run "$1" -i "$packages"/*.deb
[ -x "$1/usr/bin/asperity-generate" ]
[ "$(wc -l <"$1/var/ldconfig")" -eq 2 ]  # for libasperity and asperity-mpi
run "$1" --purge asperity-mpi python3-asperity asperity libasperity-dev "libasperity${version%.*}"
[ "$(wc -l <"$1/var/ldconfig")" -ge 4 ]
diff <(echo "$before") <(files "$1")
