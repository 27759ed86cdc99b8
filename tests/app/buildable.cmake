# What is said of rods before the search, and what makes a design that cannot be built.
cmake_minimum_required(VERSION 3.25)
include(${CMAKE_CURRENT_LIST_DIR}/run_tencer.cmake)

# The first line is that of what is to be built.
function(expect_first_line text start)
  string(FIND "${text}" "${start}" at)
  if(NOT at EQUAL 0)
    message(SEND_ERROR "does not start with '${start}': ${text}")
  endif()
endfunction()

run_tencer(target ellipse --vertices 24 -o ring.obj)
run_tencer(design ring.obj -o ring --effort 1)
expect_status(0)
expect_first_line("${err}" "1 closed rod, 180.9 cm, circle r 1.5 mm, glass fibre, 24 g; fits in 65 x 50 x 0 cm")
run_tencer(design ring.obj -o ash --material ash --effort 1)
expect_status(0)
expect_first_line("${err}" "1 closed rod, 180.9 cm, circle r 0.76 mm, ash, 2.2 g; fits in ")
file(READ ${WORK}/ash/design.json design)
expect_contains("${design}" "\"schema\": \"tencer-design/2\"")
expect_contains("${design}" "\"section\": {\"shape\":\"circle\",\"radius\":0.076}")
expect_contains("${design}" "\"name\": \"ash\"")

# A section that breaks is told, and the file says why it falls short.
file(WRITE ${WORK}/thick.toml "[[rod]]\ncurve = \"ring.obj\"\nsection = {radius = 1}\n")
run_tencer(design thick.toml -o thick --effort 1)
expect_status(3)
expect_contains("${err}" "warning: the rod is bent to a strain of 5.")
expect_contains("${out}" "not complete: the rod is bent to a strain of ")
file(READ ${WORK}/thick/design.json design)
expect_contains("${design}" "\"shortfalls\": [")
expect_contains("${design}" "glass fibre breaks at 2 %; a radius of 0.")

# Corners are no bends.
file(WRITE ${WORK}/square.xyz "0 0 0\n5 0 0\n10 0 0\n10 5 0\n10 10 0\n5 10 0\n0 10 0\n0 5 0\n0 0 0\n")
run_tencer(design square.xyz -o square --effort 1)
expect_status(3)
expect_contains("${err}" "warning: the rod has a corner at arc length 0 cm, (0, 0, 0)")

# A ring that does not repeat its first point, in the unit of its header.
file(WRITE ${WORK}/open.csv "x(mm),y(mm),z(mm)\n")
foreach(point "10,0,0" "8.66,5,0" "5,8.66,0" "0,10,0" "-5,8.66,0" "-8.66,5,0" "-10,0,0" "-8.66,-5,0"
    "-5,-8.66,0" "0,-10,0" "5,-8.66,0" "8.66,-5,0")
  file(APPEND ${WORK}/open.csv "${point}\n")
endforeach()
run_tencer(design open.csv -o closed --closed --effort 1)
expect_status(0)
expect_first_line("${err}" "1 closed rod, 62.12 mm, ")
run_tencer(design open.csv -o open --effort 1)
expect_first_line("${err}" "1 open rod, 56.94 mm, ")
expect_contains("${err}" "this curve is open, with its ends 5.18 apart, as far as neighbours")
refused("thick.toml: " "is for bare curves" design thick.toml -o out --closed)

# A check is of the material that the file names.
run_tencer(check ash/design.json --json)
string(JSON material GET "${out}" holds material)
if(NOT material STREQUAL "ash")
  message(SEND_ERROR "the check is of ${material}")
endif()

# What errors may move is as the command line says.
run_tencer(target trefoil-hypotrochoid --vertices 24 -o small.obj)
run_tencer(design small.obj -o strict --max-deviation 0.1mm --effort 1)
expect_status(3)
expect_contains("${out}" "not the 0.1 mm allowed")
refused("--max-deviation" "%, mm, cm or m, found 3 feet" design small.obj -o out
  --max-deviation "3 feet")

# Too few vertices for what they stand for are told.
run_tencer(target torus-knot --vertices 48 -o coarse.obj)
run_tencer(design coarse.obj -o coarse --effort 1)
expect_status(3)
expect_contains("${out}" "converged: with 8 edges for each ")
