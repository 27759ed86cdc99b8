# What a check says of designs, and what it leaves behind.
cmake_minimum_required(VERSION 3.25)
include(${CMAKE_CURRENT_LIST_DIR}/run_tencer.cmake)

# A ring pulled into an ellipse by a cable or two is as good-natured as can be.
run_tencer(target ellipse --vertices 40 -o ring.obj)
run_tencer(design ring.obj -o ring --quiet)
expect_status(0)
run_tencer(check ring/design.json)
expect_status(0)
foreach(line "stands: yes" "forgives: cables cut to 1 mm and tied to 2 mm: within "
    "comes back: 20 of 20 pushes by " "holds: " "weight: left out of the pose; hung " "clear: " "converged: yes")
  expect_contains("\n${out}" "\n${line}")
endforeach()
string(FIND "${out}" "fails" at)
if(NOT at EQUAL -1)
  message(SEND_ERROR "it fails: ${out}")
endif()

# The same for programs, and in the files; what was checked can be simulated and checked again.
run_tencer(check ring/design.json --json -o checked)
expect_status(0)
string(JSON passed GET "${out}" passed)
string(JSON draws GET "${out}" forgives draws)
file(READ ${WORK}/checked/design.json design)
string(JSON in_file GET "${design}" check forgives draws)
if(NOT passed STREQUAL "ON" OR NOT draws EQUAL 10000 OR NOT in_file EQUAL draws)
  message(SEND_ERROR "passed ${passed}, ${draws} draws, in the file ${in_file}")
endif()
run_tencer(simulate checked/design.json)
expect_status(0)

# Errors a tenth as large move it a tenth as far.
function(expected_deviation error result)
  run_tencer(check ring/design.json --json --length-error ${error} --attachment-error 0)
  string(JSON expected GET "${out}" forgives expected)
  string(REGEX MATCH "^0\\.0*[1-9][0-9][0-9][0-9]" digits "${expected}")
  set(${result} "${digits}" PARENT_SCOPE)
endfunction()
expected_deviation(0.1 small)
expected_deviation(1 large)
string(REGEX REPLACE "^0\\." "0.0" tenth "${large}")
if(NOT small STREQUAL tenth)
  message(SEND_ERROR "errors of 0.1 mm: ${small}; of 1 mm: ${large}")
endif()

# The same seed draws the same, another one others.
foreach(run "1;first" "1;again" "2;other")
  list(GET run 0 seed)
  list(GET run 1 name)
  run_tencer(check ring/design.json --json --seed ${seed} --draws 100)
  string(JSON ${name} GET "${out}" forgives worst)
endforeach()
if(NOT first STREQUAL again OR first STREQUAL other)
  message(SEND_ERROR "worst of seeds 1, 1 and 2: ${first}, ${again}, ${other}")
endif()

# What fails is said, and the exit code says that something does.
run_tencer(check ring/design.json --max-deviation 0.001mm --breaking-load 0.001)
expect_status(3)
expect_contains("${out}" "fails: forgives: with cables cut to 1 mm and tied to 2 mm it is within ")
expect_contains("${out}" "fails: holds: cable ")

# Rings that nothing ties to each other move at no cost. Through each other they can be tied: what
# was added is said, and the files have it.
function(write_rings second)
  file(WRITE ${WORK}/rings.toml "[[rod]]\nfamily = \"ellipse\"\nvertices = 40\n"
    "[[rod]]\nspline = [${second}]\nvertices = 40\n"
    "[design]\nrod_pairs = [[0, 0], [1, 1]]\n")
endfunction()
write_rings("[60, 1, 2], [53, 1, 20], [30, 1, 27], [7, 1, 20], [0, 1, 2], [7, 1, -16], \
[30, 1, -23], [53, 1, -16], [60, 1, 2]")
run_tencer(design rings.toml -o rings --quiet)
expect_status(3)
run_tencer(check rings/design.json)
expect_status(3)
expect_contains("${out}" "fails: stands: rod 0 moves freely at no cost")
run_tencer(check rings/design.json --repair --length-error 0 --attachment-error 0 -o tied)
expect_contains("${out}" "\nstands: yes")
string(REGEX MATCH "repair: ([0-9]+) cables added .*; with them the pose moves by [0-9.]+ mm\n"
  added "${out}")
set(count ${CMAKE_MATCH_1})
if(NOT added OR "${out}" MATCHES "fails: (stands|repair)" OR count GREATER 10)
  message(SEND_ERROR "not repaired with few cables: ${out}")
endif()
foreach(folder rings tied)
  file(READ ${WORK}/${folder}/design.json design)
  string(JSON cables_${folder} LENGTH "${design}" cables)
endforeach()
math(EXPR more "${cables_tied} - ${cables_rings}")
string(JSON said GET "${design}" check repair cables)
if(NOT more EQUAL count OR NOT said EQUAL count)
  message(SEND_ERROR "${count} cables said, ${said} in the check, ${more} in the file")
endif()
run_tencer(check tied/design.json --repair --length-error 0 --attachment-error 0)
expect_contains("${out}" "repair: none needed")

# One above the other they cannot, for cables only pull.
write_rings("[30, 0, 20], [21, 18, 20], [0, 25, 20], [-21, 18, 20], [-30, 0, 20], \
[-21, -18, 20], [0, -25, 20], [21, -18, 20], [30, 0, 20]")
run_tencer(design rings.toml -o apart --quiet)
expect_status(3)
run_tencer(check apart/design.json --repair --length-error 0 --attachment-error 0)
expect_status(3)
expect_contains("${out}" "fails: repair: not possible: no cables were found ")
