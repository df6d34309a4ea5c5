#!/usr/bin/env bash
# The cpp blocks of docs/library.md are one program, and what it prints is what their comments tell.
set -euo pipefail
rm -rf "$1" && mkdir -p "$1"
cd "$1"
awk '/^```cpp$/ { code = 1; next } /^```/ { code = 0 } code' "$source/docs/library.md" >blocks
file_scope='^(#include|using namespace)'
{ grep -E "$file_scope" blocks; echo 'int main() {'; grep -vE "$file_scope" blocks; echo '}'; } >page.cpp
sed -n 's|^ *// prints ||p' blocks >told
[ -s told ]
export PKG_CONFIG_PATH="$prefix/$libdir/pkgconfig"
"$CXX" -std=c++20 -O0 -Wall -Wextra -Werror page.cpp -o page $(pkg-config --cflags --libs asperity)
LD_LIBRARY_PATH="$prefix/$libdir" ./page >printed
diff told printed
