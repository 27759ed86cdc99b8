# Pictures of a design: from a file of it, and as it is designed.
cmake_minimum_required(VERSION 3.25)
include(${CMAKE_CURRENT_LIST_DIR}/run_tencer.cmake)

# The file begins as those of its format do, written in hexadecimal digits.
function(expect_start path start)
  string(LENGTH ${start} digits)
  math(EXPR bytes "${digits} / 2")
  file(READ ${WORK}/${path} found LIMIT ${bytes} HEX)
  if(NOT found STREQUAL start)
    message(SEND_ERROR "${path} begins with ${found}")
  endif()
endfunction()

run_tencer(target ellipse --vertices 40 -o ellipse.obj)
run_tencer(design ellipse.obj -o ring --picture ring/ring.pdf --picture ring.svg --quiet)
expect_status(0)
expect_start(ring/ring.pdf 25504446)

# The one beside the design, the one asked for with it and one drawn from its file are the same.
run_tencer(picture ring/design.json -o again.svg -o ring.PNG)
expect_status(0)
expect_contains("${out}" "see again.svg\nsee ring.PNG\n")
expect_start(ring.PNG 89504e47)
foreach(one ring/picture.svg again.svg)
  file(READ ${WORK}/${one} drawn)
  file(READ ${WORK}/ring.svg with_design)
  if(NOT drawn STREQUAL with_design)
    message(SEND_ERROR "${one} is not ring.svg")
  endif()
endforeach()

run_tencer(picture ring/design.json -o views.svg --view front,top --caption "A ring" --quiet)
expect_status(0)
if(NOT "${out}${err}" STREQUAL "")
  message(SEND_ERROR "--quiet, but: ${out}${err}")
endif()

refused("ring.jpg" "let the name end with .svg, .pdf or .png" picture ring/design.json -o ring.jpg)
refused("ring.jpg" "let the name end with .svg, .pdf or .png"
  design ellipse.obj -o other --picture ring.jpg)
refused("none/ring.svg" "there is no folder" design ellipse.obj -o other --picture none/ring.svg)
refused("--view" "did you mean front?" picture ring/design.json -o a.svg --view frnt)
refused("there-is-none.json" "" picture there-is-none.json -o a.svg)
