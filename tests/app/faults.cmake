# Faults of the machine: one clear line, the right exit code, and what was there stays.
cmake_minimum_required(VERSION 3.25)
include(${CMAKE_CURRENT_LIST_DIR}/run_tencer.cmake)

run_tencer(target ellipse --vertices 30 -o ring.obj)
expect_status(0)
run_tencer(design ring.obj -o kept --quiet)
expect_status(0)
file(SHA256 ${WORK}/kept/design.json kept)

# Runs a shell command in which \$1 is the program; sets status, out and err.
function(run_shell command)
  execute_process(COMMAND ${BASH} -c "${command}" bash ${TENCER} WORKING_DIRECTORY ${WORK}
    RESULT_VARIABLE status OUTPUT_VARIABLE out ERROR_VARIABLE err)
  return(PROPAGATE status out err)
endfunction()

# Standard output that cannot be written.
if(EXISTS /dev/full)
  foreach(command "target ellipse" "simulate kept/design.json" "design ring.obj -o other")
    run_shell("\"$1\" ${command} >/dev/full")
    expect_status(1)
    expect_contains("${err}" "tencer: standard output cannot be written\n")
    string(REGEX MATCH "tencer: [^\n]*\n$" last "${err}")
    record("tencer ${command} >/dev/full" "${last}")
  endforeach()
  # A device is written to, not replaced.
  file(CREATE_LINK /dev/full ${WORK}/full.obj SYMBOLIC)
  refused("full.obj: " "cannot be written: No space left on device" target ellipse -o full.obj)
  if(NOT IS_SYMLINK ${WORK}/full.obj)
    message(SEND_ERROR "the link to the device was replaced")
  endif()
endif()

# Folders in which nobody may write.
if(EXISTS /proc/self)
  refused("/proc/out: " "cannot be made a folder" design ring.obj -o /proc/out)
  refused("/proc: " "cannot be written" design ring.obj -o /proc)
endif()

# Memory that runs out, wherever that happens.
run_tencer(target torus-knot --vertices 20000 -o long.obj)
expect_status(0)
run_shell("ulimit -v 4000000; \"$1\" --version")
if(status STREQUAL 0) # address sanitizers reserve more than that
  foreach(kilobytes 120000 100000 80000)
    run_shell("ulimit -v ${kilobytes}; \"$1\" design long.obj -o kept --force --quiet")
    if(NOT err STREQUAL "tencer: out of memory\n" OR NOT status STREQUAL 1)
      message(SEND_ERROR "${kilobytes} kB: exit code ${status}, stdout: ${out}stderr: ${err}")
    endif()
    record("ulimit -v ${kilobytes}; tencer design long.obj -o kept --force --quiet" "${err}")
  endforeach()
endif()

file(SHA256 ${WORK}/kept/design.json now)
if(NOT now STREQUAL kept)
  message(SEND_ERROR "a failed run changed the design that was there")
endif()

# Sanitized programs reserve more memory than was given.
if(EXISTS /dev/full AND EXISTS /proc/self AND status STREQUAL 1)
  check_page("The machine")
endif()
