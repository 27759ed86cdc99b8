# What the sheet says can be measured again: marks and lengths are read from the PDF alone, found on
# the rods of design.json, and compared with it.
cmake_minimum_required(VERSION 3.25)
include(${CMAKE_CURRENT_LIST_DIR}/run_tencer.cmake)

# Two square rods through each other, A in the plane z = 0 and B in the plane y = 10, with cables of
# round lengths. s and coordinates are such that they are whole in tenths of a millimetre.
set(link [=[{
"schema": "tencer-design/2",
"name": "a link, \"tied\"",
"length_unit": "cm",
"force_unit": "N",
"rods": [
{"closed": true, "EA": 500000, "EI": [5000, 5000], "GJ": 4000,
"section": {"shape": "circle", "radius": 0.2},
"material": {"name": "glass fibre", "youngs_modulus": 4e10, "density": 2000, "strain_limit": 0.01,
"breaking_strain": 0.02},
"rest_lengths": [10, 10, 10, 10, 10, 10, 10, 10],
"target": @A@, "pose": @A@},
{"closed": true, "EA": 500000, "EI": [5000, 5000], "GJ": 4000,
"section": {"shape": "circle", "radius": 0.2},
"rest_lengths": [10, 10, 10, 10, 10, 10, 10, 10],
"target": @B@, "pose": @B@}
],
"anchors": [[2.5, 0, -12], [5, 5, 40]],
"pinned": [],
"cables": [
{"a": {"rod": 0, "s": 2.5}, "b": {"rod": 0, "s": 42.5}, "length": 25, "tension": 4},
{"a": {"rod": 0, "s": 20}, "b": {"rod": 1, "s": 45}, "length": 15, "tension": 2.5},
{"a": {"rod": 1, "s": 70}, "b": {"rod": 0, "s": 62.5}, "length": 12.5, "tension": 0.125},
{"a": {"anchor": 0}, "b": {"rod": 0, "s": 2.5}, "length": 12, "tension": 1}
],
"certificate": {"residual": 0, "smallest_eigenvalue": 1, "slack_cables": 0, "stable": true}
}
]=])
set(A "[[0, 0, 0], [10, 0, 0], [20, 0, 0], [20, 10, 0], [20, 20, 0], [10, 20, 0], [0, 20, 0], [0, 10, 0]]")
set(B "[[10, 10, -10], [20, 10, -10], [30, 10, -10], [30, 10, 0], [30, 10, 10], [20, 10, 10], [10, 10, 10], [10, 10, 0]]")
string(CONFIGURE "${link}" link @ONLY)
string(JSON material GET "${link}" rods 0 material)
string(JSON link SET "${link}" rods 1 material "${material}")
file(WRITE ${WORK}/link/design.json "${link}")

run_tencer(fabricate link/design.json --joint 30 --knot 5cm --stock 1m --price-rod 2)
expect_status(0)
expect_contains("${out}" "link/sheet/sheet.pdf: 2 rods, 4 cables, cut with 30 mm for a joint and 50 mm")
expect_contains("${err}" "warning: link/design.json: the design is not checked")

# text_of(FOLDER RESULT): the words of a sheet, a table's row on a line.
function(text_of folder result)
  execute_process(COMMAND ${PDFTOTEXT} -layout sheet.pdf - WORKING_DIRECTORY ${WORK}/${folder}
    OUTPUT_VARIABLE text COMMAND_ERROR_IS_FATAL ANY)
  set(${result} "${text}" PARENT_SCOPE)
endfunction()
text_of(link/sheet text)
foreach(words "Not checked: " "In theory it stands" "Rods A and B are linked (linking number 1)"
    "Cut 830.0 mm: 800.0 mm and 30.0 mm by which its ends overlap"
    "The joint is at 312.5 mm, where marks leave most room: there the piece begins; the nearest mark is 112.5 mm from it."
    "The joint is at the start; the nearest mark is 100.0 mm from it"
    "Buy 2 bars of 1000.0 mm, the fewest possible" "340.0 mm are left over" "Cost 4.00"
    "rod B  ·  strip 5 of 6  ·  640.0 to 810.0 mm")
  string(REGEX REPLACE "[ \n]+" " " words "${words}")
  string(REGEX REPLACE "[ \n]+" " " flat "${text}")
  expect_contains("${flat}" "${words}")
endforeach()

# In tenths of a millimetre: of "42.5" on the sheet, and of as many centimetres in the design.
function(tenths number zeros result)
  if(NOT number MATCHES "^(-?[0-9]+)(\\.([0-9]))?0*$")
    message(FATAL_ERROR "not a number with one decimal: ${number}")
  endif()
  set(decimal ${CMAKE_MATCH_3})
  if("${decimal}" STREQUAL "")
    set(decimal 0)
  endif()
  math(EXPR tenths "${CMAKE_MATCH_1}${decimal} ${zeros}")
  set(${result} ${tenths} PARENT_SCOPE)
endfunction()

# The point x, y, z of a design at s on a rod. Edges are along axes, 1000 tenths long.
function(point_at rod s)
  math(EXPR edge "${s} / 1000")
  math(EXPR rest "${s} % 1000")
  math(EXPR next "(${edge} + 1) % 8")
  set(point "")
  foreach(axis 0 1 2)
    string(JSON from GET "${link}" rods ${rod} pose ${edge} ${axis})
    string(JSON to GET "${link}" rods ${rod} pose ${next} ${axis})
    math(EXPR value "100 * (${from}) + (${to} - (${from})) / 10 * ${rest}")
    list(APPEND point ${value})
  endforeach()
  set(point ${point} PARENT_SCOPE)
endfunction()

# The place that a sheet calls "A 42.5" or "anchor 1".
function(place words)
  set(point "")
  if(words MATCHES "^anchor ([0-9]+)$")
    if(NOT text MATCHES "\n *anchor ${CMAKE_MATCH_1} +(-?[0-9.]+) +(-?[0-9.]+) +(-?[0-9.]+) +([^\n]+)\n")
      message(FATAL_ERROR "the sheet does not say where ${words} is")
    endif()
    foreach(coordinate ${CMAKE_MATCH_1} ${CMAKE_MATCH_2} ${CMAKE_MATCH_3})
      tenths(${coordinate} "" value)
      list(APPEND point ${value})
    endforeach()
  else()
    string(REPLACE " " ";" words "${words}")
    list(GET words 1 s)
    tenths(${s} "" s)
    if(words MATCHES "^A")
      point_at(0 ${s})
    else()
      point_at(1 ${s})
    endif()
  endif()
  set(point ${point} PARENT_SCOPE)
endfunction()

set(end "([AB] [0-9.]+|anchor [0-9]+)")
foreach(cable 1 2 3 4)
  if(NOT text MATCHES
      "\n *${cable} +${end} +${end} +([0-9.]+) +([0-9.]+) +([0-9.]+) +([0-9.]+)\n")
    message(FATAL_ERROR "no cable ${cable} in the sheet: ${text}")
  endif()
  set(from "${CMAKE_MATCH_1}")
  set(to "${CMAKE_MATCH_2}")
  set(tension "${CMAKE_MATCH_3}")
  set(centres ${CMAKE_MATCH_4})
  set(knots ${CMAKE_MATCH_5})
  set(cut ${CMAKE_MATCH_6})
  foreach(length centres knots cut)
    tenths(${${length}} "" ${length})
  endforeach()
  # As long as its two places are apart, and as the design says.
  place("${from}")
  set(a ${point})
  place("${to}")
  set(square 0)
  foreach(x y IN ZIP_LISTS a point)
    math(EXPR square "${square} + (${x} - (${y})) * (${x} - (${y}))")
  endforeach()
  math(EXPR expected "${centres} * ${centres}")
  math(EXPR index "${cable} - 1")
  string(JSON length GET "${link}" cables ${index} length)
  tenths(${length} "* 10" length)
  string(JSON pull GET "${link}" cables ${index} tension)
  if(NOT square EQUAL expected OR NOT centres EQUAL length OR NOT tension STREQUAL pull)
    message(SEND_ERROR "cable ${cable} from ${from} to ${to}: ${centres} tenths of a mm, "
      "${tension} N; in the design ${length}, ${pull} N; its places are ${square}^0.5 apart")
  endif()
  # Less the radii, 2 mm; more the knots, 50 mm.
  set(radii 40)
  if(from MATCHES "anchor")
    set(radii 20)
  endif()
  math(EXPR free "${centres} - ${radii}")
  math(EXPR whole "${free} + 1000")
  if(NOT knots EQUAL free OR NOT cut EQUAL whole)
    message(SEND_ERROR "cable ${cable} is ${knots} between knots, not ${free}; cut to ${cut}, not ${whole}")
  endif()
endforeach()

# Each end is a mark of its rod, in the order along it; so are they in marks.csv and on the strips.
# The piece of rod A begins at its joint, since a mark is 25 mm from the start.
read_table(link/sheet/marks.csv "design,rod,s_mm,from_end_mm,cable,end" 7 marks)
set(expected "A 425 112.5 1 to" "A 625 312.5 3 to" "A 25 512.5 1 from" "A 25 512.5 4 to"
  "A 200 687.5 2 from" "B 450 450 2 to" "B 700 700 3 from")
set(rod_A "")
set(rod_B "")
foreach(line row IN ZIP_LISTS marks expected)
  string(REPLACE " " "," fields "${row}")
  if(NOT line STREQUAL "\"a link, \"\"tied\"\"\",${fields}")
    message(SEND_ERROR "marks.csv has ${line}, not ${row}")
  endif()
  string(REPLACE " " ";" row "${row}")
  list(GET row 0 rod)
  list(GET row 1 s)
  list(GET row 2 from_end)
  list(GET row 3 cable)
  list(GET row 4 end)
  list(APPEND rod_${rod} ${from_end})
  set(on_piece "")
  if(rod STREQUAL A)
    string(REPLACE "." "\\." on_piece "${from_end} +")
  endif()
  if(NOT text MATCHES "( |\n)${on_piece}${s}\\.0 +${cable} +${end} +[AaB]")
    message(SEND_ERROR "no mark of cable ${cable} at ${s}.0 of rod ${rod} in the sheet")
  endif()
endforeach()
foreach(rod A B)
  file(READ ${WORK}/link/sheet/strip-${rod}.svg strip)
  # The rod and its overlap, 830 mm, and a margin of 10 at either end.
  foreach(part "width=\"850mm\" height=\"37mm\" viewBox=\"0 0 850 37\"" "d=\"M 10 10 L 840 10 L 840 27 "
      "stroke-width:0.4;[^>]*d=\"M 810 10 L 810 27 ")
    if(NOT strip MATCHES "${part}")
      message(SEND_ERROR "no ${part} in strip-${rod}.svg")
    endif()
  endforeach()
  string(REPLACE ";" " " strip "${strip}")
  string(REGEX MATCHALL "rgb\\(78%,18%,7%\\) [^>]*d=\"M [0-9.]+ 10 L" found "${strip}")
  list(TRANSFORM found REPLACE ".*M ([0-9.]+) 10 L" "\\1")
  list(REMOVE_DUPLICATES rod_${rod})
  set(places "")
  foreach(from_end ${rod_${rod}})
    string(REGEX MATCH "^([0-9]+)(\\.[0-9])?" whole "${from_end}")
    math(EXPR x "${CMAKE_MATCH_1} + 10")
    list(APPEND places ${x}${CMAKE_MATCH_2})
  endforeach()
  if(NOT found STREQUAL places)
    message(SEND_ERROR "marks on strip-${rod}.svg at ${found}, not ${places}")
  endif()
endforeach()
read_table(link/sheet/cables.csv
  "design,cable,from,from_s_mm,to,to_s_mm,tension_N,between_centres_mm,between_knots_mm,cut_mm,tying_step" 4 cables)
list(GET cables 3 cable)
expect_contains("${cable}" ",4,anchor 1,,A,25,1,120,118,218,")
read_table(link/sheet/rods.csv "design,rod,closed,length_mm,cut_mm,outer_radius_mm,mass_kg,joint_s_mm,nearest_mark_to_joint_mm" 2 rods)
list(GET rods 0 rod)
expect_contains("${rod}" ",A,true,800,830,2,0.0208")
# Rods of 800 mm whose ends overlap by 30: a bar of a metre each. Cables have no coil.
read_table(link/sheet/pieces.csv "design,material,bar_or_coil,of,from_mm,cut_mm" 6 pieces)
foreach(row "\"a link, \"\"tied\"\"\",rod,1,A,0,830" "\"a link, \"\"tied\"\"\",rod,2,B,0,830"
    "\"a link, \"\"tied\"\"\",cable,,1,0,")
  expect_contains("${pieces}" "${row}")
endforeach()
read_table(link/sheet/anchors.csv "design,anchor,x_mm,y_mm,z_mm" 2 anchors)
list(GET anchors 0 anchor)
expect_contains("${anchor}" ",anchor 1,25,0,-120")

# The same design gives the same bytes; letter paper is of its size.
run_tencer(fabricate link/design.json --joint 3cm --knot 50 --stock 100cm --price-rod 2.0 -o again)
file(GLOB files RELATIVE ${WORK}/link/sheet ${WORK}/link/sheet/*)
list(LENGTH files count)
if(NOT count EQUAL 8)
  message(SEND_ERROR "files of a sheet: ${files}")
endif()
foreach(file ${files})
  file(SHA256 ${WORK}/link/sheet/${file} one)
  file(SHA256 ${WORK}/again/${file} other)
  if(NOT one STREQUAL other)
    message(SEND_ERROR "${file} differs from run to run")
  endif()
endforeach()
run_tencer(fabricate link/design.json --paper letter -o letter)
expect_status(0)
file(STRINGS ${WORK}/letter/sheet.pdf box REGEX "MediaBox \\[ ?0 0 61[12][.0-9]* 79[12]" LIMIT_COUNT 1)
if(box STREQUAL "")
  message(SEND_ERROR "letter/sheet.pdf is not of 8.5 x 11 inches")
endif()

# Strips of rods that the design no longer has are gone; what else there is stays.
foreach(name C D F note)
  file(WRITE ${WORK}/letter/strip-${name}.svg "")
endforeach()
run_tencer(fabricate link/design.json -o letter)
expect_status(0)
file(GLOB strips RELATIVE ${WORK}/letter ${WORK}/letter/strip-*)
if(NOT strips STREQUAL "strip-A.svg;strip-B.svg;strip-F.svg;strip-note.svg")
  message(SEND_ERROR "strips in the folder: ${strips}")
endif()

# What a check found is on the cover.
# checked(PASSED FAILS SECTIONS WORDS...): the file with such a check of these sections, and what the
# sheet then says.
function(checked passed fails sections)
  list(TRANSFORM sections REPLACE "(.+)" "{\"section\": \"\\1\", \"text\": \"\", \"fails\": false}")
  list(JOIN sections ", " lines)
  string(JSON design SET "${link}" check "{\"passed\": ${passed}, \"fails\": [${fails}],
    \"lines\": [${lines}], \"forgives\": {\"length_error\": 0.1, \"attachment_error\": 0.2,
    \"percentile_95\": 0.2123}}")
  file(WRITE ${WORK}/checked.json "${design}")
  run_tencer(fabricate checked.json -o checked)
  expect_status(0)
  text_of(checked text)
  foreach(words IN LISTS ARGN)
    expect_contains("${text}" "${words}")
  endforeach()
  set(err "${err}" PARENT_SCOPE)
endfunction()
set(all "stands;forgives;comes back;holds;weight;clear;converged")
checked(true "" "${all}" "Checked: it passes"
  "Cables cut to 1 mm and tied to 2 mm: within 2.12 mm of the drawing")
if(NOT err STREQUAL "")
  message(SEND_ERROR "a design that passes: ${err}")
endif()
list(REMOVE_ITEM all "comes back" holds)
checked(null "" "${all}" "Checked in part: nothing fails" "Not looked at: comes back, holds.")
expect_contains("${err}" "warning: checked.json: the design is checked in part only")
checked(false "\"stands: it does not\"" "${all}" "Checked: it does not pass" "stands: it does not.")
expect_contains("${err}" "warning: checked.json: the design does not pass its check")

# What cannot be cut is refused, and leaves nothing behind.
file(COPY_FILE ${WORK}/link/design.json ${WORK}/link.json)
refused("link.json: " "cable 1 is cut to 366.0 mm, longer than a coil of 300.0 mm"
  fabricate link.json --coil 300 -o out)
refused("link.json: " "bars of 20.0 mm are no longer than the 30.0 mm that a joint takes"
  fabricate link.json --stock 20 --joint 30 -o out)
refused("link.json: " "cannot be made a folder: link.json is a file" fabricate checked.json -o link.json)
string(JSON broken SET "${link}" check "{\"passed\": 1}")
file(WRITE ${WORK}/broken.json "${broken}")
refused("broken.json: check.passed: " "true or false" fabricate broken.json -o out)
