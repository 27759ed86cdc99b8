# A design for other programs, read by them where they are installed: assimp (assimp-utils), ezdxf
# (python3-ezdxf) and VTK (python3-vtk9).
cmake_minimum_required(VERSION 3.25)
include(${CMAKE_CURRENT_LIST_DIR}/run_tencer.cmake)

run_tencer(target ellipse --vertices 40 -o ellipse.obj)
run_tencer(design ellipse.obj -o ring --quiet)
expect_status(0)
set(files ring.obj ring.vtp ring.gltf ring.glb ring.dxf ring.csv)
set(outputs "")
foreach(name IN LISTS files)
  list(APPEND outputs -o ${name})
endforeach()
run_tencer(export ring/design.json ${outputs})
expect_status(0)
foreach(name IN LISTS files)
  if(NOT EXISTS ${WORK}/${name})
    message(SEND_ERROR "no ${name}: ${err}")
  endif()
endforeach()
expect_contains("${out}" "ring.obj: lengths in cm")
expect_contains("${out}" "ring.glb: lengths in m\n")

if(NOT ASSIMP)
  set(ASSIMP "")
endif()
if(PYTHON)
  execute_process(
    COMMAND ${PYTHON} ${CMAKE_CURRENT_LIST_DIR}/read_exports.py ${ASSIMP}
    WORKING_DIRECTORY ${WORK} RESULT_VARIABLE status OUTPUT_VARIABLE out ERROR_VARIABLE err)
  message(STATUS "${out}")
  expect_status(0)
else()
  message(STATUS "SKIPPED: no Python, so that no other program reads the files")
endif()

refused("knot.stl" "let the name end with one of .obj" export ring/design.json -o knot.stl)
refused("there-is-none.json" "" export there-is-none.json -o knot.obj)
