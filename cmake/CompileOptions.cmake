# asperity_options: warnings and code generation of all targets of the project.
add_library(asperity_options INTERFACE)
target_compile_options(asperity_options INTERFACE
  -Wall -Wextra -Wpedantic -Wconversion -Wshadow
  # GCC 12 reports its own AVX-512 intrinsics as uninitialised and its own std::string as overlapping or out of bounds (GCC
  # bugs 105593, 105651); in a precompiled header it does not treat them as system headers.
  $<$<CXX_COMPILER_ID:GNU>:-Wno-uninitialized;-Wno-maybe-uninitialized;-Wno-restrict;-Wno-array-bounds;-Wno-stringop-overflow>
  -fno-math-errno -fno-trapping-math
  $<$<BOOL:${ASPERITY_WARNINGS_AS_ERRORS}>:-Werror>
  $<$<BOOL:${ASPERITY_NATIVE}>:-march=native>)
if(ASPERITY_SANITIZE)
  target_compile_options(asperity_options INTERFACE -fsanitize=address,undefined -fno-sanitize-recover=undefined -fno-omit-frame-pointer)
  target_link_options(asperity_options INTERFACE -fsanitize=address,undefined)
endif()
if(ASPERITY_COVERAGE)  # several threads count
  target_compile_options(asperity_options INTERFACE -Og --coverage -fprofile-update=atomic)
  target_link_options(asperity_options INTERFACE --coverage)
endif()
if(ASPERITY_FUZZ)
  if(NOT CMAKE_CXX_COMPILER_ID MATCHES Clang)
    message(FATAL_ERROR "ASPERITY_FUZZ needs clang: cmake --preset fuzz")
  endif()
  target_compile_options(asperity_options INTERFACE -fsanitize=fuzzer-no-link,address,undefined -fno-sanitize-recover=undefined -fno-omit-frame-pointer)
  target_link_options(asperity_options INTERFACE -fsanitize=address,undefined)
endif()

# asperity_library(LIBRARY): the options above, the version, and the visibility of symbols. A shared library exports all
# its symbols, because the tests use them, but no inline functions: users may compile those of Eigen for another instruction
# set. Until 1.0 a minor version may change the binary interface. GCC may inline within the library, as clang does.
function(asperity_library library)
  set_target_properties(${library} PROPERTIES
    VERSION ${PROJECT_VERSION} SOVERSION ${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR} VISIBILITY_INLINES_HIDDEN ON)
  target_compile_options(${library} PRIVATE $<$<CXX_COMPILER_ID:GNU>:-fno-semantic-interposition>)
  target_link_libraries(${library} PRIVATE $<BUILD_INTERFACE:asperity_options>)
  target_precompile_headers(${library} PRIVATE ${asperity_common_headers})
endfunction()

# Headers that nearly every source includes, compiled once per target.
set(asperity_common_headers <Eigen/Core> <algorithm> <array> <cmath> <complex> <cstdint> <functional> <limits> <map>
  <memory> <numbers> <numeric> <optional> <span> <sstream> <string> <string_view> <utility> <vector>)

# Tools and tests compile faster with less optimisation; the libraries do the expensive arithmetic. The little that the tools
# compute must have the same bits as with -O3. Plain -O1 does not fuse multiplications and additions: a test may not expect its
# own arithmetic to have the bits of the library's.
foreach(kind tool test)
  add_library(asperity_${kind}_options INTERFACE)
  target_link_libraries(asperity_${kind}_options INTERFACE asperity_options)
endforeach()
target_compile_options(asperity_tool_options INTERFACE $<$<CONFIG:Release>:-O2>)
target_compile_options(asperity_test_options INTERFACE $<$<CONFIG:Release>:-O1>)

# asperity_batches(LIBRARY ROOM...): with ASPERITY_BATCHES, compiles the sources of these rooms eight at a time, in the order in
# which a room lists them. Their private names are unique in a room. Rooms of few headers gain nothing by it.
function(asperity_batches library)
  get_target_property(sources ${library} SOURCES)
  set_target_properties(${library} PROPERTIES UNITY_BUILD ${ASPERITY_BATCHES} UNITY_BUILD_MODE GROUP)
  foreach(room ${ARGN})
    set(of_room ${sources})
    list(FILTER of_room INCLUDE REGEX "/${room}/[a-z_0-9]+.cpp$")
    set(place 0)
    foreach(source ${of_room})
      math(EXPR batch "${place} / 8")
      set_source_files_properties(${source} TARGET_DIRECTORY ${library} PROPERTIES UNITY_GROUP ${room}_${batch})
      math(EXPR place "${place} + 1")
    endforeach()
  endforeach()
endfunction()
