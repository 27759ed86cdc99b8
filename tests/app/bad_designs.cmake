# Design files that cannot be simulated.
cmake_minimum_required(VERSION 3.25)
include(${CMAKE_CURRENT_LIST_DIR}/run_tencer.cmake)

# A bow: an open rod whose ends one cable draws together. Without stiffness and rest length.
set(bow [=[{
"schema": "tencer-design/1",
"length_unit": "cm",
"force_unit": "N",
"rods": [{
"closed": false,
"EA": 1000,
"EI": [1, 1],
"GJ": 1,
"rest_lengths": [1, 1, 1],
"target": [[0, 0, 0], [0.8, 0.6, 0], [1.8, 0.6, 0], [2.6, 0, 0]],
"pose": [[0, 0, 0], [0.8, 0.6, 0], [1.8, 0.6, 0], [2.6, 0, 0]]
}],
"anchors": [],
"pinned": [],
"cables": [{"a": {"rod": 0, "s": 0}, "b": {"rod": 0, "s": 3}, "length": 2.6, "tension": 1}]
}
]=])

# bad_design(OLD NEW WHERE REMEDY): the bow with one part replaced.
function(bad_design old new where remedy)
  string(FIND "${bow}" "${old}" at)
  if(at EQUAL -1)
    message(FATAL_ERROR "the bow has no ${old}")
  endif()
  string(REPLACE "${old}" "${new}" content "${bow}")
  file(WRITE ${WORK}/bow.json "${content}")
  set(tried "${old} -> ${new}")
  refused("${where}: " "${remedy}" simulate bow.json -o out)
endfunction()

file(WRITE ${WORK}/bow.json "${bow}")
run_tencer(simulate bow.json)
expect_status(0)
refused("bow.json: cables[0]: " "give it both" simulate bow.json --cables springs -o out)

refused("none.json: " "there is no such file" simulate none.json -o out)
bad_design("tencer-design/1" "tencer-design/3" "bow.json: schema" "expected \"tencer-design/2\"")
bad_design("\"schema\": \"tencer-design/1\"," "" "bow.json" "the key \"schema\" is missing")
bad_design("\"EA\": 1000" "\"EA\": " "bow.json:7" "is not valid JSON")
bad_design("\"rods\": [{" "\"rods\": [], \"spare\": [{" "bow.json: rods" "at least one rod")
bad_design("\"EA\": 1000" "\"EA\": 0" "bow.json: rods[0].EA" "expected a positive number")
bad_design("[1, 1],\n\"GJ\"" "[1, -1],\n\"GJ\"" "bow.json: rods[0].EI[1]" "expected a positive number")
bad_design("[1, 1, 1]" "[1, 1]" "bow.json: rods[0].rest_lengths" "expected 3 numbers, found 2")
bad_design("\"closed\": false" "\"closed\": true" "bow.json: rods[0].rest_lengths"
  "expected 4 numbers, found 3")
bad_design("\"pose\": [[0, 0, 0], " "\"pose\": [" "bow.json: rods[0].pose" "expected 4 points")
bad_design("\"pose\": [[0, 0, 0], [0.8, 0.6, 0]" "\"pose\": [[0, 0, 0], [0, 0, 0]"
  "bow.json: rods[0].pose[0]" "zero-length edge")
bad_design("\"target\": [[0, 0, 0], [0.8, 0.6, 0]" "\"target\": [[0, 0, 0], [0, 0, 0]"
  "bow.json: rods[0].target[0]" "zero-length edge")
bad_design("[2.6, 0, 0]],\n\"pose\"" "[0.8, 0.6, 0]],\n\"pose\"" "bow.json: rods[0].target[2]"
  "straight back")
bad_design("\"s\": 3}" "\"s\": 3.1}" "bow.json: cables[0].b.s" "expected an arc length from 0 to 3")
bad_design("\"s\": 0}" "\"s\": -1}" "bow.json: cables[0].a.s" "not negative")
bad_design("\"a\": {\"rod\": 0, \"s\": 0}" "\"a\": {\"rod\": 1, \"s\": 0}" "bow.json: cables[0].a.rod"
  "there is no rod 1")
bad_design("\"a\": {\"rod\": 0, \"s\": 0}" "\"a\": {\"anchor\": 0}" "bow.json: cables[0].a.anchor"
  "there is no anchor 0")
bad_design("\"s\": 3}" "\"s\": 0}" "bow.json: cables[0]" "move one of them")
bad_design("\"length\": 2.6" "\"length\": 0" "bow.json: cables[0].length" "expected a positive number")
bad_design("\"tension\": 1" "\"tension\": 1, \"stiffness\": 5" "bow.json: cables[0]"
  "give both or neither")
bad_design("\"pinned\": []" "\"pinned\": [{\"rod\": 0, \"vertex\": 4, \"axes\": \"x\"}]"
  "bow.json: pinned[0].vertex" "there is no vertex 4")

check_page("Design files")
