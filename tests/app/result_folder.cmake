# A folder holds one result: nothing of an earlier one is left, and another's is not replaced.
cmake_minimum_required(VERSION 3.25)
include(${CMAKE_CURRENT_LIST_DIR}/run_tencer.cmake)

function(expect_files folder)
  file(GLOB_RECURSE names RELATIVE ${WORK}/${folder} ${WORK}/${folder}/*)
  list(SORT names)
  set(expected ${ARGN})
  list(SORT expected)
  if(NOT names STREQUAL expected)
    message(SEND_ERROR "in ${folder}: ${names}")
  endif()
endfunction()
set(files design.json trace.csv pose.obj report.txt view.html picture.svg)

file(WRITE ${WORK}/straight.xyz "0 0 0\n1 0 0\n2 0 0\n3 0 0\n")
file(WRITE ${WORK}/other.xyz "0 0 0\n1 0 0\n2 0 0\n4 0 0\n")

# A design takes the place of a trade-off; what else is in the folder stays.
run_tencer(design straight.xyz -o out --trade-off --quiet)
expect_status(0)
list(TRANSFORM files PREPEND cables-0/ OUTPUT_VARIABLE below)
expect_files(out ${files} trade-off.csv ${below})
file(WRITE ${WORK}/out/notes.txt "mine\n")
file(WRITE ${WORK}/out/cables-7/notes.txt "mine\n")
file(WRITE ${WORK}/out/cables-7/design.json "{}\n")
file(WRITE ${WORK}/out/feasible.json "{}\n")
run_tencer(design straight.xyz -o out --quiet)
expect_status(0)
expect_files(out ${files} notes.txt cables-7/notes.txt)

# A sheet is somebody's work at a bench: it stays, and is said to be old.
file(WRITE ${WORK}/out/sheet/sheet.pdf "%PDF\n")
run_tencer(design straight.xyz -o out --quiet)
expect_status(0)
expect_contains("${err}" "warning: out/sheet/sheet.pdf is of an earlier run: make it anew with")
expect_files(out ${files} notes.txt cables-7/notes.txt sheet/sheet.pdf)
file(REMOVE_RECURSE ${WORK}/out/sheet)

# Another's design is kept, also by a dry run, unless --force is given.
foreach(how "" --dry-run)
  refused("out: holds the design of 'straight', not of 'other'" "--force"
    design other.xyz -o out ${how})
endforeach()
run_tencer(design other.xyz -o out --quiet --force)
expect_status(0)
file(READ ${WORK}/out/design.json design)
string(JSON name GET "${design}" name)
if(NOT name STREQUAL other)
  message(SEND_ERROR "--force, but it is ${name}")
endif()
run_tencer(design straight.xyz -o kept --quiet)
expect_status(0)
foreach(command simulate check)
  refused("out: holds the design of 'other', not of 'straight'" "--force"
    ${command} kept/design.json -o out)
endforeach()
refused("out: holds a design" "name another folder" feasible other.xyz -o out)

# So is what is no design.
file(WRITE ${WORK}/mine/design.json "{\"colour\": \"red\"}\n")
refused("mine/design.json: is there and is no design that can be read" "--force"
  design straight.xyz -o mine)

# A shape that cables cannot hold leaves the design that is there.
file(WRITE ${WORK}/two.obj
  "v 0 0 0\nv 1 0 0\nv 2 0 0\nv 3 0 0\nv 0 1 0\nv 1 1 0\nv 2 1 0\nv 3 1 0\nl 1 2 3 4\nl 5 6 7 8\n")
run_tencer(design two.obj -o two --quiet)
expect_status(3)
expect_files(two feasible.json picture.svg)
run_tencer(design two.obj -o out --quiet --force)
expect_status(3)
expect_files(out ${files} notes.txt cables-7/notes.txt)
