# What people have besides a curve file and a scene: a curve through a pipe, a unit, a closed curve
# that does not say so, a published model.
cmake_minimum_required(VERSION 3.25)
include(${CMAKE_CURRENT_LIST_DIR}/run_tencer.cmake)

set(ring "10 0\n7 7\n0 10\n-7 7\n-10 0\n-7 -7\n0 -10\n7 -7\n")
file(WRITE ${WORK}/ring.txt "${ring}")
execute_process(COMMAND ${TENCER} design - --closed --unit in -o piped
  INPUT_FILE ${WORK}/ring.txt WORKING_DIRECTORY ${WORK}
  RESULT_VARIABLE status OUTPUT_VARIABLE out ERROR_VARIABLE err)
expect_status(3)  # a polygon of eight corners
expect_contains("${err}" "standard input:1: two numbers a line: z is taken as 0")
expect_contains("${err}" "1 closed rod, 154.8")
file(READ ${WORK}/piped/design.json design)
expect_contains("${design}" "25.4")
if(err MATCHES "this curve is open")
  message(SEND_ERROR "closed, and said to be open: ${err}")
endif()

# A scene comes through a pipe as well.
file(WRITE ${WORK}/scene.toml "[[rod]]\ncurve = \"ring.txt\"\nclosed = true\n")
execute_process(COMMAND ${TENCER} feasible - INPUT_FILE ${WORK}/scene.toml
  WORKING_DIRECTORY ${WORK} RESULT_VARIABLE status OUTPUT_VARIABLE out ERROR_VARIABLE err)
if(NOT status MATCHES "^[03]$")
  message(SEND_ERROR "exit code ${status}: ${err}")
endif()

refused("scene.toml: " "is for bare curves" design scene.toml --unit mm)

file(WRITE ${WORK}/model.json [=[{"name": "bow", "rods": [{"closed": false, "youngs_modulus": 4e6,
  "radius": 0.1, "rest_lengths": [2, 2, 2, 2],
  "target": [[0, 0, 0], [1.7, 1, 0], [3.7, 1.4, 0], [5.7, 1, 0], [7.4, 0, 0]],
  "published_equilibrium": [[0, 0, 0], [1.7, 1, 0], [3.7, 1.4, 0], [5.7, 1, 0], [7.4, 0, 0]]}],
  "anchors": [], "cables": [{"a": {"rod": 0, "s": 0}, "b": {"rod": 0, "s": 8}, "stiffness": 1e4,
  "rest_length": 7.39}]}]=])
run_tencer(simulate model.json -o settled)
if(NOT status MATCHES "^[03]$")
  message(SEND_ERROR "exit code ${status}: ${err}")
endif()
expect_contains("${out}" "1 cable")
file(READ ${WORK}/settled/design.json design)
string(JSON name GET "${design}" name)
string(JSON unit GET "${design}" length_unit)
if(NOT name STREQUAL "bow" OR NOT unit STREQUAL "cm")
  message(SEND_ERROR "the design is ${name} in ${unit}")
endif()
