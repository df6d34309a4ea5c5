#!/usr/bin/env bash
set -euo pipefail
rm -rf "$1" && mkdir -p "$1/project"
cat >"$1/project/CMakeLists.txt" <<CMAKE
cmake_minimum_required(VERSION 3.25)
project(Whole LANGUAGES C CXX)
enable_testing()
add_subdirectory($source asperity EXCLUDE_FROM_ALL)
get_target_property(kind asperity TYPE)
if(NOT kind STREQUAL STATIC_LIBRARY OR DEFINED CACHE{BUILD_SHARED_LIBS} OR CMAKE_BUILD_TYPE)
  message(FATAL_ERROR "what is the whole project's to choose was chosen: \${kind} \${CMAKE_BUILD_TYPE}")
endif()
CMAKE
cmake -S "$1/project" -B "$1/build" -DCMAKE_CXX_COMPILER="$CXX" >/dev/null
ctest --test-dir "$1/build" -N | grep -q '^Total Tests: 0$'
cmake --install "$1/build" --prefix "$1/prefix" >/dev/null
[ ! -e "$1/prefix" ] || { find "$1/prefix" >&2; exit 1; }
