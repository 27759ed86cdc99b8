# Scenes with mistakes: the line names the file and the line or key.
cmake_minimum_required(VERSION 3.25)
include(${CMAKE_CURRENT_LIST_DIR}/run_tencer.cmake)

run_tencer(target ellipse --vertices 24 -o ring.obj)
expect_status(0)

# bad_scene(CONTENT WHERE REMEDY): the content follows a [[rod]] table of three lines.
set(rod "[[rod]]\ncurve = \"ring.obj\"\n\n")
function(bad_scene content where remedy)
  file(WRITE ${WORK}/scene.toml "${rod}${content}")
  set(tried "${content}")
  refused("${where}: " "${remedy}" design scene.toml -o out)
endfunction()
# The content comes before it.
function(bad_top content where remedy)
  file(WRITE ${WORK}/scene.toml "${content}\n${rod}")
  set(tried "${content}")
  refused("${where}: " "${remedy}" design scene.toml -o out)
endfunction()

refused("none.toml: " "there is no such file" design none.toml -o out)
file(WRITE ${WORK}/empty.toml "")
refused("empty.toml:1: " "at least one [[rod]] table" design empty.toml -o out)
bad_scene("[design\nmax_error = 1\n" "scene.toml:4" "is not valid TOML")
bad_scene("[design]\nmax_eror = 1\n" "scene.toml:5" "did you mean max_error?")
bad_top("colour = 1" "scene.toml:1" "unknown key colour")

# Curves
bad_scene("[[rod]]\ncurve = \"none.obj\"\n" "scene.toml:5: rod[1].curve" "there is no file none.obj")
file(WRITE ${WORK}/bad.obj "v 0 0 0\nv 0 0 y\n")
bad_scene("[[rod]]\ncurve = \"bad.obj\"\n" "bad.obj:2" "'y' is not a number")
bad_scene("[[rod]]\nfamily = \"knot\"\n" "scene.toml:5: rod[1].family" "torus-knot")
bad_scene("closed = false\n" "scene.toml:4: rod[0].closed" "remove the key or open the curve")
bad_scene("[[rod]]\nfamily = \"helix\"\nclosed = true\n" "scene.toml:6: rod[1].closed"
  "give it points on the way")
bad_scene("[[rod]]\ncurve = \"ring.obj\"\n" "scene.toml" "two rods cross")

# Sections
bad_scene("material = \"cheese\"\n" "scene.toml:4: rod[0].material" "expected one of glass fibre, ")
bad_scene("section = {radius = 30}\n" "scene.toml" "make the rod thinner")
foreach(bad "0" "-1" "nan" "\"stiff\"")
  bad_scene("section = {EA = ${bad}, EI = 1, GJ = 1}\n" "scene.toml:4: rod[0].section.EA" "expected a ")
  bad_scene("section = {EA = 1, EI = ${bad}, GJ = 1}\n" "scene.toml:4: rod[0].section.EI" "expected a ")
  bad_scene("section = {EA = 1, EI = 1, GJ = ${bad}}\n" "scene.toml:4: rod[0].section.GJ" "expected a ")
  bad_scene("section = {radius = ${bad}}\n" "scene.toml:4: rod[0].section.radius" "expected a ")
  bad_scene("section = {youngs_modulus = ${bad}}\n" "scene.toml:4: rod[0].section.youngs_modulus"
    "expected a ")
endforeach()

# Anchors
bad_top("anchors = [[99, 0, 0], [0, 99, 0], [0, 0, 99]]" "scene.toml: anchors"
  "give at least 4 that are not in a plane")
bad_top("anchors = [[9, 9, 9], [9, 9, 9], [9, 9, 9], [9, 9, 9], [9, 9, 9]]" "scene.toml: anchors"
  "enclose nothing")
bad_top("anchors = [[50, 50, -50], [90, 50, -50], [50, 90, -50], [50, 50, 90]]"
  "scene.toml: anchors" "convex hull must enclose the target")
bad_top("anchors = [[200, 200, 200], [-200, -200, 200], [200, -200, -200], [-200, 200, -200], [32.5, 0, 0]]"
  "scene.toml" "vertex 0 of rods[0] and anchors[4] coincide")
bad_top("anchors = [[1, 2]]" "scene.toml:1" "expected a point [x, y, z]")

# Rules
bad_scene("[design]\nrod_pairs = []\n" "scene.toml:5: design.rod_pairs" "such as [0, 0]")
bad_scene("[design]\nrod_pairs = [[0, 1]]\n" "scene.toml:5: design.rod_pairs" "there is no rod 1")
bad_scene("[design]\nlongest_cable = 0.1\n" "scene.toml: design.longest_cable" "no cables are allowed")
bad_scene("[design]\nlongest_cable = -1\n" "scene.toml:5: design.longest_cable"
  "expected a positive number")
bad_scene("[design]\nforbidden_arcs = [{rod = 0, from = 0, to = 180}]\n"
  "scene.toml: design.forbidden_arcs" "no cables are allowed")
bad_scene("[design]\nforbidden_arcs = [{rod = 0, from = 0, to = 999}]\n"
  "scene.toml:5: design.forbidden_arcs[0].to" "expected an arc length from 0 to")
bad_scene("[design]\nforbidden_vertices = [{rod = 0, vertices = [24]}]\n"
  "scene.toml:5: design.forbidden_vertices[0].vertices" "there is no vertex 24")
bad_scene("[design]\nexternal = true\n" "scene.toml:5: design.external" "add anchors")
bad_scene("[design]\nmax_error = -1\n" "scene.toml:5: design.max_error" "expected a positive number")
bad_scene("[design]\noptimizer = \"snopt\"\n" "scene.toml:5: design.optimizer" "ipopt, mma, ccsaq")
bad_scene("[design]\noptimizer = \"mma\"\nhessian = \"exact\"\n" "scene.toml:6: design.hessian"
  "belongs to the optimizer ipopt")
bad_scene("[design]\nhand_over = true\n" "scene.toml:5: design.hand_over"
  "no pinned vertices to hand over")

# Symmetries
bad_scene("[design]\nsymmetry = [{fold = 5, axis = [0, 0, 1]}]\n" "scene.toml: design.symmetry[0]"
  "misses what it should become by")
bad_scene("[design]\nsymmetry = [{fold = 1, axis = [0, 0, 1]}]\n"
  "scene.toml:5: design.symmetry[0].fold" "a whole number from 2")
bad_scene("[design]\nsymmetry = [{normal = [0, 0, 0]}]\n" "scene.toml:5: design.symmetry[0].normal"
  "must not be zero")
bad_scene("[design]\nsymmetry = \"mirror\"\n" "scene.toml:5: design.symmetry" "detect")

check_page("Scene files")
