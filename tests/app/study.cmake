# A study: a table and a picture a scene, whatever becomes of single runs; what is done is not done
# again.
cmake_minimum_required(VERSION 3.25)
include(${CMAKE_CURRENT_LIST_DIR}/run_tencer.cmake)

# Designed at once: held by a cable or two, at rest without any, and one that is refused.
run_tencer(target ellipse --vertices 24 -o ring.obj)
expect_status(0)
file(WRITE ${WORK}/straight.xyz "0 0 0\n1 0 0\n2 0 0\n3 0 0\n4 0 0\n")
file(WRITE ${WORK}/broken.toml "[[rod]]\ncurve = \"ring.obj\"\ncolour = \"red\"\n")

# The lines of a table but for the seconds.
function(table folder result)
  file(READ ${WORK}/${folder}/study.csv text)
  string(REGEX REPLACE "[^\n]*\n(.*)" "\\1" text "${text}")
  set(${result} "${text}" PARENT_SCOPE)
endfunction()
function(count_lines folder result)
  file(STRINGS ${WORK}/${folder}/study.csv lines)
  list(LENGTH lines count)
  math(EXPR count "${count} - 1")
  set(${result} ${count} PARENT_SCOPE)
endfunction()

# One scene that fails does not stop the study.
run_tencer(study broken.toml ring.obj straight.xyz -o all --methods force-balance)
expect_status(3)
expect_contains("${out}" "broken, force-balance, gauss-newton, x1: ")
expect_contains("${out}" "failed: broken.toml:3: ")
expect_contains("${out}" "1 run is not complete")
count_lines(all lines)
if(NOT lines EQUAL 3)
  message(SEND_ERROR "${lines} lines, not 3")
endif()
table(all first)
expect_contains("${first}" "broken,broken.toml,force-balance,gauss-newton,1,failed,")
expect_contains("${first}" "ring,ring.obj,force-balance,gauss-newton,1,complete,24,")
expect_contains("${first}" "straight,straight.xyz,force-balance,gauss-newton,1,complete,5,0,0,")
foreach(file ring.dat ring.gp runs/ring-force-balance-gauss-newton-x1/design.json
    runs/broken-force-balance-gauss-newton-x1.log)
  if(NOT EXISTS ${WORK}/all/${file})
    message(SEND_ERROR "no all/${file}")
  endif()
endforeach()

# Pictures where there is gnuplot; otherwise it is said, and all else is there.
if(GNUPLOT)
  string(REGEX REPLACE "  [^\n]*; [0-9.]+ s\n" "" complaints "${err}") # but for what is done now
  if(NOT complaints STREQUAL "")
    message(SEND_ERROR "pictures can be made, but: ${complaints}")
  endif()
  file(READ ${WORK}/all/ring.svg picture)
  expect_contains("${picture}" "<svg")
  expect_contains("${picture}" "force-balance, gauss-newton")
endif()
execute_process(COMMAND ${CMAKE_COMMAND} -E env PATH=/nonexistent
  ${TENCER} study ring.obj -o bare --methods force-balance --quiet
  WORKING_DIRECTORY ${WORK} RESULT_VARIABLE status OUTPUT_VARIABLE out ERROR_VARIABLE err)
expect_status(0)
expect_contains("${err}" "there is no gnuplot (in Debian the package gnuplot-nox)")
table(bare lines)
expect_contains("${lines}" "ring,ring.obj,force-balance,gauss-newton,1,complete,24,")
if(EXISTS ${WORK}/bare/ring.svg OR NOT EXISTS ${WORK}/bare/ring.gp)
  message(SEND_ERROR "without gnuplot there is a script and no picture")
endif()

# Again: nothing is made, and the table keeps every byte; more runs come to it; --again makes them.
run_tencer(study broken.toml ring.obj straight.xyz -o all --methods force-balance)
expect_status(3)
expect_contains("${err}" "ring, force-balance, gauss-newton, x1: done before")
table(all second)
if(NOT first STREQUAL second)
  message(SEND_ERROR "a second run changes the table:\n${first}now\n${second}")
endif()
run_tencer(study ring.obj -o all --methods force-balance --resolutions 0.5,1 --quiet)
expect_status(0)
count_lines(all lines)
if(NOT lines EQUAL 4)
  message(SEND_ERROR "${lines} lines, not 4")
endif()
table(all third)
expect_contains("${third}" "ring,ring.obj,force-balance,gauss-newton,0.5,complete,12,")
expect_contains("${third}" "${first}")
file(REMOVE_RECURSE ${WORK}/all/runs)
run_tencer(study ring.obj -o all --methods force-balance --again --quiet)
expect_status(0)
count_lines(all lines)
if(NOT lines EQUAL 4 OR NOT EXISTS ${WORK}/all/runs/ring-force-balance-gauss-newton-x1/design.json)
  message(SEND_ERROR "--again: ${lines} lines, or no design")
endif()

# Both methods, and an optimizer by name.
run_tencer(study ring.obj -o both --optimizers gauss-newton --quiet)
expect_status(0)
table(both lines)
expect_contains("${lines}" "ring,ring.obj,force-balance,gauss-newton,1,complete,")
expect_contains("${lines}" "ring,ring.obj,dense-springs,gauss-newton,1,complete,")

# Killed during a run of many seconds: a table with the runs before it, with which a study goes on.
run_tencer(target torus-knot --vertices 301 -o knot.obj)
execute_process(COMMAND ${TENCER} study straight.xyz knot.obj -o killed --methods force-balance --quiet
  WORKING_DIRECTORY ${WORK} TIMEOUT 6 RESULT_VARIABLE status OUTPUT_VARIABLE out ERROR_VARIABLE err)
expect_contains("${status}" "timeout")
count_lines(killed lines)
if(NOT lines EQUAL 1)
  message(SEND_ERROR "${lines} lines of the killed study, not 1")
endif()

# A run that is out of time ends with what it has, and its line says so.
run_tencer(study straight.xyz knot.obj -o killed --methods force-balance --time-limit 2)
expect_status(3)
expect_contains("${err}" "straight, force-balance, gauss-newton, x1: done before")
table(killed lines)
expect_contains("${lines}" "knot,knot.obj,force-balance,gauss-newton,1,")
expect_contains("${lines}" "time limit of 2 s")

# The solver against closed forms.
run_tencer(study --closed-forms -o forms --quiet)
expect_status(0)
read_table(forms/closed-forms.csv "problem,edges,seconds,relative_error" 30 lines)

# Mistakes.
refused("SCENES: " "--closed-forms" study -o none)
refused("other/ring.obj: " "has the name of ring.obj" study ring.obj other/ring.obj -o none)
refused("other/ring.obj: " "has the name of ring.obj in all/study.csv"
  study other/ring.obj -o all --methods force-balance)
refused("--optimizers: " "this build has: " study ring.obj -o none --optimizers snopt)
refused("--methods: " "use one of force-balance, dense-springs" study ring.obj -o none --methods luck)
foreach(value 0 nan 1000)
  refused("--resolutions: " "${value}" study ring.obj -o none --resolutions 1,${value})
endforeach()
refused("--time-limit: " "expected a positive number" study ring.obj -o none --time-limit 0)
file(WRITE ${WORK}/bare/study.csv "a,b\n1,2\n")
refused("bare/study.csv:2: " "remove this table" study ring.obj -o bare)
