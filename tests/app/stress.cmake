# Every extreme case converges or names its trouble, as docs/stability.md says it does.
cmake_minimum_required(VERSION 3.25)
include(${CMAKE_CURRENT_LIST_DIR}/run_tencer.cmake)

run_tencer(stress --markdown)
expect_status(0)

# The case and verdict of every row; the digits depend on the compiler.
function(verdicts text result)
  string(REGEX MATCHALL "\n\\| [^|\n]+ \\| (converged|reported|FAILED) \\|" rows "${text}")
  set(${result} "${rows}" PARENT_SCOPE)
endfunction()
verdicts("${out}" found)
file(READ ${PAGE} page)
verdicts("${page}" written)
list(LENGTH found cases)
if(cases LESS 100)
  message(SEND_ERROR "only ${cases} cases")
endif()
if(NOT found STREQUAL written)
  message(SEND_ERROR "the tables of docs/stability.md differ from those of tencer stress:\n${found}")
endif()
