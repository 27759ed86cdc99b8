# Pins handed over to cables to anchors, and symmetries given and offered, from the scene to the file.
cmake_minimum_required(VERSION 3.25)
include(${CMAKE_CURRENT_LIST_DIR}/run_tencer.cmake)

# An arch between two pins, in the plane.
set(points "")
foreach(i RANGE 20)
  math(EXPR height "${i} * (20 - ${i})")
  string(APPEND points "${i},${height}e-2,0\n")
endforeach()
file(WRITE ${WORK}/arch.csv "${points}")
set(rod "[[rod]]\ncurve = 'arch.csv'\n")
set(pinned "pinned = [{rod = 0, vertex = 0}, {rod = 0, vertex = 20}]\n")
set(frame "planar = true\nframe = {shape = 'cube', margin = 4}\n")
set(design "[design]\nexternal = false\nhand_over = true\n[build]\nlength_error = 0.02\nattachment_error = 0.02\n")
file(WRITE ${WORK}/arch.toml "${frame}${pinned}${rod}${design}")
run_tencer(design arch.toml -o arch --verbose)
expect_status(0)
expect_contains("${err}" "hand-over: ")
expect_contains("${out}" "let go at the target it comes to rest in this pose")
file(READ ${WORK}/arch/design.json text)
string(JSON pins ERROR_VARIABLE none LENGTH "${text}" pinned)
if(pins GREATER 0)
  message(SEND_ERROR "${pins} pins are left")
endif()
string(JSON cables LENGTH "${text}" cables)
if(cables EQUAL 0)
  message(SEND_ERROR "nothing holds the arch")
endif()
run_tencer(simulate arch/design.json --from target)
expect_status(0)

# What is not symmetric is said, with how far off it is.
file(WRITE ${WORK}/turned.toml "${rod}[design]\nsymmetry = [{fold = 3, axis = [0, 0, 1]}]\n")
refused("turned.toml: design.symmetry[0]: the 3-fold rotation about the axis (0, 0, 1) through (10, "
  "the rod misses what it should become by" design turned.toml -o turned)

# The anchors are elsewhere.
file(WRITE ${WORK}/apart.toml
  "planar = true\nanchors = [[0, 9, 0], [20, 9, 0], [10, 2, 0]]\n${pinned}${rod}${design}")
refused("apart.toml: design.hand_over: the anchors must surround every pinned vertex" "vertex 0 of the rod"
  design apart.toml -o apart)

# A symmetry is offered once, and not when the scene has said no.
run_tencer(target trefoil-2-3 --vertices 36 -o knot.obj)
expect_status(0)
run_tencer(design knot.obj -o knot --max-error 5)
string(REGEX MATCHALL "the target has a [0-9]-fold rotation about" offers "${err}")
list(LENGTH offers count)
if(NOT count EQUAL 1)
  message(SEND_ERROR "${count} offers in: ${err}")
endif()
run_tencer(design knot.obj -o knot --max-error 5 --symmetry none)
string(FIND "${err}" "the target has" at)
if(NOT at EQUAL -1)
  message(SEND_ERROR "an offer, but --symmetry none: ${err}")
endif()
