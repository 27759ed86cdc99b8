# Ctrl-C and SIGTERM during a design leave the best one so far, whichever thread they reach; a second
# one ends the program.
cmake_minimum_required(VERSION 3.25)
include(${CMAKE_CURRENT_LIST_DIR}/run_tencer.cmake)

# After its first report on this curve the program has many seconds of work left.
run_tencer(target torus-knot --vertices 151 -o knot.obj)
expect_status(0)

# Runs a design that is sent these signals, in turn; sets status, out and err.
function(interrupt preload hold)
  file(REMOVE_RECURSE ${WORK}/out)
  execute_process(
    COMMAND ${CMAKE_COMMAND} -E env PRELOAD=${preload} ${hold} ASAN_OPTIONS=verify_asan_link_order=0
      ${BASH} ${CMAKE_CURRENT_LIST_DIR}/interrupt.sh ${TENCER} ${ARGN}
    WORKING_DIRECTORY ${WORK} RESULT_VARIABLE status OUTPUT_VARIABLE out ERROR_VARIABLE err)
  return(PROPAGATE status out err)
endfunction()

function(expect_best_so_far)
  expect_status(3)
  expect_contains("${out}" "interrupted: this is the best design so far")
  file(READ ${WORK}/out/design.json design)
  expect_contains("${design}" "\"status\": \"interrupted\"")
endfunction()

interrupt("" "" INT)
expect_best_so_far()
interrupt(${EARLY_THREAD} "" INT)
expect_best_so_far()
interrupt(${EARLY_THREAD} "" TERM)
expect_best_so_far()
# It is a design like any other.
run_tencer(simulate out/design.json --cables springs)
expect_status(0)

# 128 and the number of the signal, as shells have it.
interrupt(${EARLY_THREAD} TENCER_HOLD=1 INT TERM)
expect_status(143)
interrupt(${EARLY_THREAD} TENCER_HOLD=1 TERM TERM)
expect_status(143)
