# What the program says of a design that does not stay in its pose.
cmake_minimum_required(VERSION 3.25)
include(${CMAKE_CURRENT_LIST_DIR}/run_tencer.cmake)

run_tencer(target ellipse --vertices 60 -o ring.obj)
expect_status(0)
run_tencer(design ring.obj -o made --quiet)
expect_status(0)

# As it was made it stays.
run_tencer(simulate made/design.json)
expect_status(0)
if(err MATCHES "warning")
  message(SEND_ERROR "a design that stays, but: ${err}")
endif()

# With a cable a tenth shorter it moves.
file(READ ${WORK}/made/design.json design)
string(JSON length GET "${design}" cables 0 length)
string(REGEX REPLACE "^([0-9]+)\\.?([0-9]?).*" "\\1\\2" tenths "${length}")
math(EXPR shorter "${tenths} * 9")
string(JSON moved SET "${design}" cables 0 length "${shorter}e-2")
file(WRITE ${WORK}/moved.json "${moved}")
run_tencer(simulate moved.json -o moved)
expect_status(3)
expect_contains("${err}" "warning: moved.json: the design does not stay in its pose: it ")
expect_contains("${err}" " % of the target's size")
file(READ ${WORK}/moved/design.json written)
expect_contains("${written}" "\"status\": \"tolerance-not-reached\"")

# Where it came to rest it stays.
run_tencer(simulate moved/design.json)
expect_status(0)
