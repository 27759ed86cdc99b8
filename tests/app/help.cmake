# Every command explains itself, with examples.
cmake_minimum_required(VERSION 3.25)
include(${CMAKE_CURRENT_LIST_DIR}/run_tencer.cmake)

function(explains)
  run_tencer(${ARGN} --help)
  expect_status(0)
  expect_contains("${out}" "Usage: ")
  expect_contains("${out}" "Examples:")
  if(NOT err STREQUAL "")
    message(SEND_ERROR "help on stderr: ${err}")
  endif()
endfunction()

explains()
explains(design)
explains(simulate)
explains(target)
explains(stress)
explains(study)

run_tencer(--version)
expect_status(0)
expect_contains("${out}" "tencer ")
