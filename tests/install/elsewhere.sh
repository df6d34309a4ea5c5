#!/usr/bin/env bash
# With programs that play the managers of packages of other systems: cmake is installed there, and nothing else.
set -euo pipefail
rm -rf "$1" && mkdir -p "$1"
. "$source/cmake/packages"

# system NAME PROGRAM...: a folder of programs, without apt
system() {
  local folder=$1 tool
  mkdir -p "$folder"
  for tool in bash env awk dirname id; do ln -s "$(command -v "$tool")" "$folder"; done
  shift
  for tool in "$@"; do
    printf '#!/usr/bin/env bash\nfor last; do :; done\n[ "$last" = cmake ]\n' >"$folder/$tool"
    chmod +x "$folder/$tool"
  done
}
system "$1/dnf" dnf rpm
system "$1/pacman" pacman
system "$1/brew" brew
system "$1/none"

# says MANAGER STATUS WORDS PACKAGE...: what install-packages prints there, and its exit status
says() {
  local manager=$1 status=$2 words=$3 found=0 said
  shift 3
  said=$(PATH="$folder/$manager" "$source/cmake/install-packages" "$@" 2>&1) || found=$?
  [ "$found" = "$status" ] && [ "$said" = "$words" ] ||
    { echo "$manager: exit $found, \"$said\"; not $status, \"$words\"" >&2; exit 1; }
}
folder=$1
missing="install-packages: missing, install them by:"
says dnf 1 "$missing sudo dnf install gsl-devel fftw-devel openmpi" cmake libgsl-dev libfftw3-dev openmpi-bin
says pacman 1 "$missing sudo pacman -S --needed eigen openmpi" libeigen3-dev libopenmpi-dev openmpi-bin gwyddion cmake
says brew 1 "$missing brew install open-mpi" build-essential libopenmpi-dev openmpi-bin zsh
says brew 1 "$missing brew install valgrind" valgrind
for manager in dnf pacman brew; do says "$manager" 0 "" cmake; done
says none 0 "install-packages: there is neither apt, dnf, pacman nor brew: what is missing of these, by Debian's names, is \
yours to install: cmake jq" cmake jq

# Every package has a row of four names.
for package in $build $run $test; do
  awk -v package="$package" '$1 == package && NF == 4 { found = 1 } END { exit !found }' "$source/cmake/package-names" ||
    { echo "cmake/package-names has no row of four names for $package" >&2; exit 1; }
done
