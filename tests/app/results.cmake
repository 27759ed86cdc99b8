# What a run leaves behind, and what it does not.
cmake_minimum_required(VERSION 3.25)
include(${CMAKE_CURRENT_LIST_DIR}/run_tencer.cmake)

run_tencer(target ellipse --vertices 30 -o ring.obj)
expect_status(0)
set(files design.json trace.csv pose.obj report.txt view.html picture.svg)

function(fingerprints folder result)
  file(GLOB names RELATIVE ${WORK}/${folder} ${WORK}/${folder}/* ${WORK}/${folder}/.*)
  set(all "")
  foreach(name IN LISTS names)
    if(NOT IS_DIRECTORY ${WORK}/${folder}/${name})
      file(SHA256 ${WORK}/${folder}/${name} hash)
      string(APPEND all "${name} ${hash}\n")
    endif()
  endforeach()
  set(${result} "${all}" PARENT_SCOPE)
endfunction()

run_tencer(design ring.obj -o first --quiet)
expect_status(0)
if(NOT out STREQUAL "" OR NOT err STREQUAL "")
  message(SEND_ERROR "--quiet, but: ${out}${err}")
endif()
foreach(file IN LISTS files)
  if(NOT EXISTS ${WORK}/first/${file})
    message(SEND_ERROR "no first/${file}")
  endif()
endforeach()
file(READ ${WORK}/first/design.json design)
expect_contains("${design}" "\"status\": \"complete\"")

# Without -o the folder is named after the input.
run_tencer(design ring.obj)
expect_status(0)
expect_contains("${err}" "1 closed rod, ")
expect_contains("${out}" ", max error ")
expect_contains("${out}" " mm (")
expect_contains("${out}" " s in all\nsee ring-design/view.html\n")
if(NOT EXISTS ${WORK}/ring-design/design.json)
  message(SEND_ERROR "no ring-design/design.json")
endif()

# The design comes to rest, with and without a folder for it.
foreach(from pose target)
  run_tencer(simulate first/design.json --from ${from})
  expect_status(0)
  expect_contains("${out}" "residual")
endforeach()
run_tencer(simulate first/design.json --cables springs -o rest/in/a/folder)
expect_status(0)
run_tencer(simulate rest/in/a/folder/design.json)
expect_status(0)

# With finer rods, which can be made finer again.
run_tencer(simulate first/design.json --refine 2 -o finer)
expect_status(0)
expect_contains("${out}" "2 edges for each")
run_tencer(simulate finer/design.json --refine 2)
expect_status(0)
run_tencer(simulate first/design.json --refine)
expect_status(0)
expect_contains("${out}" "4 edges for each")

# A tolerance that cannot be reached.
run_tencer(design ring.obj -o coarse --max-error 1e-9)
expect_status(3)
expect_contains("${out}" "the max error is above the 1e-09 % asked for")
file(READ ${WORK}/coarse/design.json design)
expect_contains("${design}" "\"status\": \"tolerance-not-reached\"")

# A straight rod needs nothing.
file(WRITE ${WORK}/straight.xyz "0 0 0\n1 0 0\n2 0 0\n3 0 0\n")
run_tencer(design straight.xyz -o straight)
expect_status(0)
expect_contains("${out}" "the rods rest in this shape by themselves")
file(READ ${WORK}/straight/design.json design)
expect_contains("${design}" "\"cables\": []")

# Two need nothing either, and are not one thing.
file(WRITE ${WORK}/two.obj
  "v 0 0 0\nv 1 0 0\nv 2 0 0\nv 3 0 0\nv 0 1 0\nv 1 1 0\nv 2 1 0\nv 3 1 0\nl 1 2 3 4\nl 5 6 7 8\n")
run_tencer(design two.obj -o two)
expect_status(3)
expect_contains("${out}" "cannot be held: rod A lies apart from the others")

# A run that fails leaves the design that is there: with bad input, and when one of the files cannot
# be written.
file(REMOVE ${WORK}/first/picture.svg)
file(MAKE_DIRECTORY ${WORK}/first/picture.svg/taken)
fingerprints(first before)
refused("none.obj: " "there is no such file" design none.obj -o first)
run_tencer(design ring.obj -o first --max-error 0.5 --quiet)
expect_status(2)
if(NOT err STREQUAL "tencer: first/picture.svg: cannot be written: Is a directory\n" OR out)
  message(SEND_ERROR "stdout: ${out}stderr: ${err}")
endif()
fingerprints(first after)
if(NOT before STREQUAL after)
  message(SEND_ERROR "a failed run changed files:\n${before}now\n${after}")
endif()
