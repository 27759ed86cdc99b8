# What is said of shapes before a search, and what it leaves behind.
cmake_minimum_required(VERSION 3.25)
include(${CMAKE_CURRENT_LIST_DIR}/run_tencer.cmake)

run_tencer(target trefoil-hypotrochoid --vertices 80 -o knot.obj)
run_tencer(feasible knot.obj)
expect_status(0)
expect_contains("${out}" "can be held: with all ")
file(GLOB left ${WORK}/*)
if(NOT left STREQUAL "${WORK}/knot.obj")
  message(SEND_ERROR "without -o it leaves ${left}")
endif()

# An open helix without anchors: the proof is written, by a design as well, and a frame mends it.
run_tencer(target helix --vertices 60 -o helix.obj)
foreach(command feasible design)
  run_tencer(${command} helix.obj -o ${command})
  expect_status(3)
  expect_contains("${out}" "cannot be held within 1 % of its size: with all ")
  expect_contains("${out}" "would do: cables to a frame about the rods: frame = {shape = \"cube\"}")
  file(READ ${WORK}/${command}/feasible.json json)
  string(JSON verdict GET "${json}" verdict)
  string(JSON vertices LENGTH "${json}" rods 0 target)
  string(JSON motions LENGTH "${json}" rods 0 motion)
  if(NOT verdict STREQUAL "cannot" OR NOT motions EQUAL vertices)
    message(SEND_ERROR "${verdict}, ${motions} motions of ${vertices} vertices")
  endif()
  file(READ ${WORK}/${command}/picture.svg picture)
  expect_contains("${picture}" "How rods move with all cables tied that are allowed")
  if(EXISTS ${WORK}/${command}/design.json)
    message(SEND_ERROR "${command} leaves a design that is none")
  endif()
endforeach()
file(WRITE ${WORK}/framed.toml
  "length_unit = \"cm\"\nframe = {shape = \"cube\"}\n[[rod]]\ncurve = \"helix.obj\"\n")
run_tencer(feasible framed.toml)
expect_status(0)

# Further off is allowed: then it is not said that it cannot.
run_tencer(feasible helix.obj --max-error 40)
expect_status(0)

refused("none.obj: " "there is no such file" feasible none.obj)
refused("--max-error" "expected a positive number" feasible knot.obj --max-error 0)
