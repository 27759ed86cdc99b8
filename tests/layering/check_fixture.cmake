# The test of check_includes.cmake: run on fixture/, it must fail and report exactly the lines of
# fixture/expected.txt.
cmake_minimum_required(VERSION 3.25)
set(fixture ${CMAKE_CURRENT_LIST_DIR}/fixture)
execute_process(
  COMMAND ${CMAKE_COMMAND} -D MANIFEST=${fixture}/manifest.cmake -D MODULES_DIR=${fixture}
    -P ${CMAKE_CURRENT_LIST_DIR}/check_includes.cmake
  RESULT_VARIABLE status ERROR_VARIABLE output)
if(status EQUAL 0)
  message(FATAL_ERROR "the fixture's violations were not reported")
endif()
string(REGEX MATCHALL "\n +[a-zA-Z_/]+\\.([ch]pp|txt):[^\n]*" found "${output}")
list(TRANSFORM found STRIP)
file(STRINGS ${fixture}/expected.txt expected)
if(NOT found STREQUAL expected)
  list(JOIN found "\n  " found)
  list(JOIN expected "\n  " expected)
  message(FATAL_ERROR "reported:\n  ${found}\nexpected:\n  ${expected}")
endif()
