# asperity_options: the warnings and code generation that every target of the project shares.
add_library(asperity_options INTERFACE)
target_compile_options(asperity_options INTERFACE
  -Wall -Wextra -Wpedantic -Wconversion -Wshadow
  # GCC 12 calls its own AVX-512 intrinsics uninitialised and its own std::string overlapping or out of bounds (GCC bugs
  # 105593, 105651); in a precompiled header it forgets that they are the system's.
  $<$<CXX_COMPILER_ID:GNU>:-Wno-maybe-uninitialized;-Wno-restrict;-Wno-array-bounds;-Wno-stringop-overflow>
  -fno-math-errno -fno-trapping-math
  $<$<BOOL:${ASPERITY_WARNINGS_AS_ERRORS}>:-Werror>
  $<$<BOOL:${ASPERITY_NATIVE}>:-march=native>)
if(ASPERITY_SANITIZE)
  target_compile_options(asperity_options INTERFACE -fsanitize=address,undefined -fno-sanitize-recover=undefined -fno-omit-frame-pointer)
  target_link_options(asperity_options INTERFACE -fsanitize=address,undefined)
endif()
if(ASPERITY_COVERAGE)  # counted by several threads
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

# What every library of the project has: the options above, its version, and what crosses its border where it is shared:
# every symbol of ours, for the tests look inside, but not the inline functions of Eigen, which a user may compile for
# other instructions. Until 1.0 a minor version may change the binary interface. GCC may inline within the library, as
# clang does.
function(asperity_library library)
  set_target_properties(${library} PROPERTIES
    VERSION ${PROJECT_VERSION} SOVERSION ${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR} VISIBILITY_INLINES_HIDDEN ON)
  target_compile_options(${library} PRIVATE $<$<CXX_COMPILER_ID:GNU>:-fno-semantic-interposition>)
  target_link_libraries(${library} PRIVATE $<BUILD_INTERFACE:asperity_options>)
  target_precompile_headers(${library} PRIVATE ${asperity_common_headers})
endfunction()

# What nearly every source of the project includes, compiled once a target.
set(asperity_common_headers <Eigen/Core> <algorithm> <array> <cmath> <complex> <cstdint> <functional> <limits> <map>
  <memory> <numbers> <numeric> <optional> <span> <sstream> <string> <string_view> <utility> <vector>)

# Tools and tests leave the arithmetic that takes time to the libraries, and compile faster. What little the tools compute
# has the bits that -O3 gives it, which -O1 alone, without fused multiplications and additions, has not.
foreach(kind tool test)
  add_library(asperity_${kind}_options INTERFACE)
  target_link_libraries(asperity_${kind}_options INTERFACE asperity_options)
endforeach()
target_compile_options(asperity_tool_options INTERFACE $<$<CONFIG:Release>:-O2>)
target_compile_options(asperity_test_options INTERFACE $<$<CONFIG:Release>:-O1>
  $<$<AND:$<CONFIG:Release>,$<CXX_COMPILER_ID:GNU>>:-fexpensive-optimizations>)
