# Curves that no design can be made for.
cmake_minimum_required(VERSION 3.25)
include(${CMAKE_CURRENT_LIST_DIR}/run_tencer.cmake)

# bad_curve(FILE CONTENT WHERE REMEDY)
function(bad_curve file content where remedy)
  file(WRITE ${WORK}/${file} "${content}")
  set(tried "${content}")
  if(content STREQUAL "")
    set(tried "an empty ${file}")
  endif()
  refused("${where}: " "${remedy}" design ${file} -o out)
endfunction()

refused("none.obj: " "there is no such file" design none.obj -o out)
file(MAKE_DIRECTORY ${WORK}/folder.obj)
refused("folder.obj: " "a file is needed" design folder.obj -o out)
bad_curve(mesh.stl "" "mesh.stl" "save the curve itself")
bad_curve(points.vtp "" "points.vtp" "save the points as CSV")
refused("/dev/zero: " "a file is needed" design /dev/zero -o out)

bad_curve(empty.obj "" "empty.obj" "no vertices (v x y z)")
bad_curve(number.obj "v 0 0 0\nv 1 x 0\n" "number.obj:2" "'x' is not a number")
bad_curve(index.obj "v 0 0 0\nv 1 0 0\nv 1 1 0\nl 1 2 9\n" "index.obj:4" "use 1 to 3")
bad_curve(zero.obj "v 0 0 0\nv 1 0 0\nl 0 1\n" "zero.obj:3" "counts from 1")
bad_curve(mesh.obj "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 1\nf 1 2 3\nf 2 3 4\n" "mesh.obj:6"
  "l (line) elements")
bad_curve(keyword.obj "v 0 0 0\nwv 1 0 0\n" "keyword.obj:2" "v (vertex) and l (line) elements")
bad_curve(nan.csv "0 0 0\n1 nan 0\n1 1 0\n" "nan.csv:2" "not a finite number")
bad_curve(two.csv "0, 0, 0\n1, 0\n" "two.csv:2" "3")
bad_curve(atoms.xyz "2\nwater\nO 0 0 0\nH 1 0 0\n" "atoms.xyz:1" "drop the count")
bad_curve(four.vect "4VECT\n1 2 0\n" "four.vect:1" "save the three coordinates")
bad_curve(path.svg "<svg><path d='M0 0 B1 1'/></svg>" "path.svg:1" "use M L H V C S Q T A Z")
bad_curve(block.dxf "0\nSECTION\n2\nENTITIES\n0\nINSERT\n0\nENDSEC\n" "block.dxf" "export the curves themselves")
bad_curve(broken.json "{\"curves\": [}" "broken.json:1" "is not valid JSON")

bad_curve(point.xyz "0 0 0\n" "point.xyz:1" "needs at least 2 points")
bad_curve(repeated.xyz "1 1 1\n1 1 1\n1 1 1\n" "repeated.xyz:1" "at least 2 different points")
bad_curve(back.xyz "0 0 0\n2 0 0\n1 0 0\n1 1 0\n" "back.xyz:2" "turns straight back")
bad_curve(crossing.xyz "0 0 0\n1 1 0\n2 0 0\n1 -1 0\n0 0 1\n-1 -1 0\n1 1 0\n1 1 1\n"
  "crossing.xyz" "the rod crosses itself: ")
# Likewise where no vertex is on the crossing.
bad_curve(eight.xyz "3 1 0\n4 0 0\n3 -1 0\n-3 1 0\n-4 0 0\n-3 -1 0\n3 1 0\n"
  "eight.xyz" "are the same point; move the curves apart there")
bad_curve(open.json
  "{\"curves\": [{\"closed\": false, \"points\": [[0,0,0], [1,0,0], [1,1,0], [0,0,0]]}]}"
  "open.json: curves[0].points" "set closed to true, or remove the last point")
bad_curve(strut.xyz "0 0 0\n1 0 0\n" "strut.xyz" "no cable is possible")
bad_curve(uneven.xyz "0 0 0\n5 0 0\n5 0.004 0\n0 5 0\n-5 5 3\n-5 0 6\n" "uneven.xyz"
  "space the points more evenly")

check_page("Curve files")
