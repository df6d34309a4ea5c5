#!/usr/bin/env bash
# By FetchContent, which calls add_subdirectory.
set -euo pipefail
rm -rf "$1" && mkdir -p "$1/project"
cat >"$1/project/CMakeLists.txt" <<CMAKE
cmake_minimum_required(VERSION 3.25)
project(Whole LANGUAGES C CXX)
enable_testing()
include(FetchContent)
FetchContent_Declare(asperity SOURCE_DIR $source)
FetchContent_MakeAvailable(asperity)
get_target_property(kind asperity TYPE)
if(NOT kind STREQUAL STATIC_LIBRARY OR DEFINED CACHE{BUILD_SHARED_LIBS} OR CMAKE_BUILD_TYPE)
  message(FATAL_ERROR "what is the whole project's to choose was chosen: \${kind} \${CMAKE_BUILD_TYPE}")
endif()
if(NOT TARGET Asperity::stats OR TARGET asperity_cli_tools OR CLI11_FOUND)
  message(FATAL_ERROR "the libraries alone were asked for")
endif()
CMAKE
cmake -S "$1/project" -B "$1/build" -DCMAKE_CXX_COMPILER="$CXX" >/dev/null
ctest --test-dir "$1/build" -N | grep -q '^Total Tests: 0$'
cmake --install "$1/build" --prefix "$1/prefix" >/dev/null
[ ! -e "$1/prefix" ] || { find "$1/prefix" >&2; exit 1; }
