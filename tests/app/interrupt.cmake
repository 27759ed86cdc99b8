# Ctrl-C during a design leaves the best one so far.
cmake_minimum_required(VERSION 3.25)
include(${CMAKE_CURRENT_LIST_DIR}/run_tencer.cmake)

# After its first report on this curve the program has many seconds of work left.
run_tencer(target torus-knot --vertices 151 -o knot.obj)
expect_status(0)
execute_process(COMMAND ${BASH} ${CMAKE_CURRENT_LIST_DIR}/interrupt.sh ${TENCER}
  WORKING_DIRECTORY ${WORK} RESULT_VARIABLE status OUTPUT_VARIABLE out ERROR_VARIABLE err)
expect_status(3)
expect_contains("${out}" "interrupted: this is the best design so far")
file(READ ${WORK}/out/design.json design)
expect_contains("${design}" "\"status\": \"interrupted\"")

# It is a design like any other.
run_tencer(simulate out/design.json --cables springs)
expect_status(0)
