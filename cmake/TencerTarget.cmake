# What all targets of this project are compiled with: warnings, and headers compiled once.
include_guard(GLOBAL)

add_library(tencer_warnings INTERFACE)
# Sources that are compiled together (CMAKE_UNITY_BUILD) see each other's names: only what hides a
# parameter or a variable of the same function is a mistake there, which clang does not tell apart.
# With so much in one place g++ 12 also takes sums of strings for overruns (GCC bug 105651).
set(by_source -Wshadow)
if(CMAKE_UNITY_BUILD)
  set(by_source $<$<CXX_COMPILER_ID:GNU>:-Wshadow=local;-Wno-array-bounds;-Wno-stringop-overflow;-Wno-restrict>)
endif()
target_compile_options(tencer_warnings INTERFACE
  -Wall -Wextra -Wpedantic ${by_source} -Wconversion -Wno-sign-conversion)
# A compiler that nobody has tried may warn of more; that must not break a build.
set(tried_GNU 12)
set(tried_Clang 14)
string(REGEX MATCH "^[0-9]+" major ${CMAKE_CXX_COMPILER_VERSION})
if(TENCER_WERROR AND major EQUAL "${tried_${CMAKE_CXX_COMPILER_ID}}")
  target_compile_options(tencer_warnings INTERFACE -Werror)
endif()

# Headers that most sources read. A source that uses one still includes it, for with
# CMAKE_DISABLE_PRECOMPILE_HEADERS=ON (preset clang) each source is compiled by itself.
set(TENCER_PRECOMPILED
  <algorithm> <array> <cmath> <filesystem> <functional> <limits> <map> <memory> <numbers> <numeric>
  <optional> <random> <set> <span> <sstream> <string> <string_view> <utility> <variant> <vector>
  <Eigen/Core> <Eigen/Geometry> <Eigen/SparseCore>)

# tencer_precompile(TARGET KIND HEADER...): TARGET reads the headers compiled. Targets of one KIND
# share them: the first one compiles them, so all must have the same flags.
function(tencer_precompile target kind)
  get_property(owner GLOBAL PROPERTY TENCER_PRECOMPILED_${kind})
  if(owner)
    target_precompile_headers(${target} REUSE_FROM ${owner})
  else()
    target_precompile_headers(${target} PRIVATE ${ARGN})
    set_property(GLOBAL PROPERTY TENCER_PRECOMPILED_${kind} ${target})
  endif()
endfunction()
