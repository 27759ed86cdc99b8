// Scenes that the reader refuses.
#include <catch2/catch.hpp>
#include <random>
#include <tencer/io/scene.hpp>

#include "curves_folder.hpp"
#include "edited.hpp"

using namespace tencer;
using namespace tencer::io;

TEST_CASE("bad scenes are refused with line, key and remedy") {
  const Curves folder;
  struct Case {
    std::string text;
    const char* error;
  };
  const std::string ring = "[[rod]]\ncurve = 'ring.obj'\n";  // lines 1, 2
  const std::string line = "[[rod]]\ncurve = 'line.csv'\n";  // lines 1, 2
  const std::string design = ring + "[design]\n";            // line 3
  const Case cases[] = {
      {"", "s.toml:1: a scene needs at least one [[rod]] table"},
      {"name = 'x'\nrod = [}\n",
       "s.toml:2: is not valid TOML: Error while parsing value: could not determine value type"},
      {"name = 3\n" + ring, "s.toml:1: name: expected a text, found 3"},
      {"\nlenght_unit = 'cm'\n" + ring,
       "s.toml:2: unknown key lenght_unit; did you mean length_unit?"},
      {"length_unit = 'inch'\n" + ring,
       "s.toml:1: length_unit: expected one of mm, cm, m, found \"inch\""},
      {"planar = 1\n" + ring, "s.toml:1: planar: expected true or false, found 1"},
      {"rod = 3", "s.toml:1: rod: expected an array of tables, found 3"},
      {"rod = [3]", "s.toml:1: rod[0]: expected a table, found 3"},
      {"[[rod]]\n",
       "s.toml:1: a rod needs either curve = \"FILE\" or family = \"NAME\" or spline = [[x, y, z], "
       "...]"},
      {ring + "family = 'circle'\n",
       "s.toml:1: a rod needs either curve = \"FILE\" or family = \"NAME\" or spline = [[x, y, z], "
       "...]"},
      {ring + "parameters = {}\n", "s.toml:3: rod[0].parameters: belongs to family only"},
      {ring + "radius = 1\n",
       "s.toml:3: unknown key rod[0].radius; known here: curve, index, family, parameters, "
       "spline, vertices, smooth, closed, section, material, director, rest, closing_turns"},
      {"[[rod]]\ncurve = 'none.obj'\n", "s.toml:2: rod[0].curve: there is no file none.obj"},
      {"[[rod]]\ncurve = 'spoilt.obj'\n", "spoilt.obj:2: 'x' is not a number"},
      {ring + "index = 1\n", "s.toml:3: rod[0].index: there is no curve 1; use 0"},
      {"[[rod]]\ncurve = 'both.obj'\nindex = 2\n",
       "s.toml:3: rod[0].index: there is no curve 2; use 0 to 1"},
      {ring + "closed = false\n",
       "s.toml:3: rod[0].closed: is false, but the curve is closed: its end meets its start; "
       "remove "
       "the key or open the curve"},
      {"[[rod]]\ncurve = 'far.csv'\nclosed = true\n",
       "s.toml:3: rod[0].closed: is true, but the ends of the curve are 5.1 apart, 3.61 times its "
       "longest edge; give it points on the way from one to the other, or leave it open"},
      {ring + "vertices = 2\n",
       "s.toml:3: rod[0].vertices: expected a whole number from 3, found 2"},
      {ring + "vertices = 2000000000\n",
       "s.toml:3: rod[0].vertices: expected a whole number of at most 20000, found 2000000000"},
      {"[[rod]]\nfamily = 'circle'\nvertices = 2000000000\n",
       "s.toml:3: rod[0].vertices: expected a whole number of at most 20000, found 2000000000"},
      {"[[rod]]\nfamily = 'circle'\nvertices = 15000\n[[rod]]\nfamily = 'circle'\nvertices = "
       "15000\n",
       "s.toml:1: the rods have 30000 vertices altogether, more than 20000; a design takes a tenth "
       "of that, so say fewer vertices of the rods"},
      {ring + "section = {radius = 1e-308}\n",
       "s.toml:3: rod[0].section: makes a stiffness of 0; look at its sizes, modulus and units"},
      {"[[rod]]\ncurve = '/dev/zero'\n", "/dev/zero: is a device; a file is needed"},
      {ring + "vertices = 10.5\n",
       "s.toml:3: rod[0].vertices: expected a whole number, found 10.5"},
      {"[[rod]]\nfamily = 'torusknot'\n",
       "s.toml:2: rod[0].family: expected one of circle, ellipse, helix, torus-knot, "
       "trefoil-hypotrochoid, trefoil-2-3, trefoil-3-2, twin-trefoils, borromean-ellipses, "
       "knot-3_1, knot-4_1, knot-5_1, knot-5_2, knot-6_1, knot-6_2, knot-6_3, knot-7_1, knot-7_2, "
       "knot-7_3, knot-7_4, knot-7_5, knot-7_6, knot-7_7, found "
       "\"torusknot\"; did you mean \"torus-knot\"?"},
      {"[[rod]]\nfamily = 'torus-knot'\nparameters = {p = 4, q = 2}\n",
       "s.toml:3: rod[0].parameters: p and q must have no common divisor, or the curve is traced "
       "several times"},
      {"[[rod]]\nfamily = 'helix'\nparameters = {turn = 4}\n",
       "s.toml:3: unknown key rod[0].parameters.turn; did you mean turns?"},
      {ring + "section = {radius = 0}\n",
       "s.toml:3: rod[0].section.radius: expected a positive number, found 0"},
      {ring + "section = {radius = nan}\n",
       "s.toml:3: rod[0].section.radius: expected a finite number, found nan"},
      {ring + "section = {youngs_modulus = -1}\n",
       "s.toml:3: rod[0].section.youngs_modulus: expected a positive number, found -1"},
      {ring + "section = {poisson = 0.6}\n",
       "s.toml:3: rod[0].section.poisson: expected a number above -1, at most 0.5"},
      {ring + "section = {shape = 'square'}\n",
       "s.toml:3: rod[0].section.shape: expected one of circle, tube, rectangle, found \"square\""},
      {ring + "section = {EA = 1, GJ = 1}\n", "s.toml:3: the key rod[0].section.EI is missing"},
      {ring + "section = {EA = 1, EI = 0, GJ = 1}\n",
       "s.toml:3: rod[0].section.EI: expected a positive number, found 0"},
      {ring + "section = {EA = 1, EI = [1, -1], GJ = 1}\n",
       "s.toml:3: rod[0].section.EI: expected a positive number, or two of them [a, b]"},
      {ring + "section = {EA = 1, EI = 1, GJ = 1, radius = 1}\n",
       "s.toml:3: unknown key rod[0].section.radius; known here: EA, EI, GJ, "
       "mass_per_length"},
      {ring + "section = {shape = 'tube', outer_radius = 1}\n",
       "s.toml:3: the key rod[0].section.inner_radius is missing"},
      {ring + "section = {shape = 'tube', outer_radius = 1, inner_radius = 1}\n",
       "s.toml:3: rod[0].section.inner_radius: must be smaller than outer_radius"},
      {ring + "section = {shape = 'rectangle', width = 1, height = 0}\n",
       "s.toml:3: rod[0].section.height: expected a positive number, found 0"},
      {ring + "section = {shape = 'rectangle', radius = 1}\n",
       "s.toml:3: unknown key rod[0].section.radius; known here: shape, width, height, "
       "youngs_modulus, poisson, density"},
      {ring + "director = [0, 0, 1]\n",
       "s.toml:3: rod[0].director: has no meaning: the section bends alike about all axes and the "
       "rod is straight at rest"},
      {ring + "director = [0, 0, 0]\n",
       "s.toml:3: rod[0].director: expected a direction, found [0, 0, 0]"},
      {ring + "director = [0, 1]\n",
       "s.toml:3: rod[0].director: expected a point [x, y, z], found an array of 2"},
      {line + "closing_turns = 1\n", "s.toml:3: rod[0].closing_turns: belongs to closed rods"},
      {ring + "rest = {curvature = 1, curve = 'both.obj'}\n",
       "s.toml:3: unknown key rod[0].rest.curve; known here: curvature"},
      {"[[rod]]\nspline = [[0, 0, 0]]\n", "s.toml:2: a curve needs at least 2 points, found 1"},
      {"[[rod]]\nspline = [[0, 0, 0], [1, 0, 0]]\nindex = 0\n",
       "s.toml:3: rod[0].index: belongs to curve or family; a spline is one curve"},
      {"[[rod]]\nspline = [[0, 0, 0], [1, 0, 0]]\nfamily = 'circle'\n",
       "s.toml:1: a rod needs either curve = \"FILE\" or family = \"NAME\" or spline = [[x, y, z], "
       "...]"},
      {"frame = {shape = 'ball'}\n" + ring,
       "s.toml:1: frame.shape: expected one of cube, tetrahedron, found \"ball\""},
      {"frame = {margin = 1}\n" + ring, "s.toml:1: the key frame.shape is missing"},
      {"frame = {shape = 'cube', margin = 0}\n" + ring,
       "s.toml:1: frame.margin: expected a positive number, found 0"},
      {"anchors = [[0, 0, 0]]\nframe = {shape = 'cube'}\n" + ring,
       "s.toml:2: frame: its corners are the anchors; give either frame or anchors"},
      {ring + "rest = {}\n",
       "s.toml:3: a rod needs either curve = \"FILE\" or family = \"NAME\" or spline = [[x, y, z], "
       "...]"},
      {ring + "rest = {curve = 'both.obj'}\n",
       "s.toml:3: rest names 2 curves; say which with index = 0, 1, ..."},
      {ring + "rest = {curve = 'both.obj', index = 1}\n",
       "s.toml:3: rod[0].rest: the curve at rest is open, the target is not; both must be the "
       "same"},
      {ring + "rest = {family = 'circle', parameters = {radius = 1}}\n",
       "s.toml:3: rod[0].rest: the curve at rest is 6.282151815625657 long and the target 16; they "
       "must agree "
       "to 1 %"},
      {ring + "rest = {curvature = -1}\n",
       "s.toml:3: rod[0].rest: with this curvature the rod bends by 4 radians from one vertex to "
       "the next; use more vertices, so that it is at most 1"},
      {ring + "section = {EA = 1, EI = [1, 2], GJ = 1}\nrest = {curve = 'both.obj', index = 0}\n",
       "s.toml:4: rod[0].rest: needs director = [x, y, z], the direction of the section's first "
       "axis at the start of the curve"},
      {ring + "material = 'cheese'\n",
       "s.toml:3: rod[0].material: expected one of glass fibre, carbon, ash, beech, spruce, "
       "bamboo, "
       "spring steel, stainless steel, aluminium, brass, found \"cheese\""},
      {ring + "material = 'ash'\nsection = {EA = 1, EI = 1, GJ = 1}\n",
       "s.toml:3: rod[0].material: has no meaning: the section is given by its stiffnesses"},
      {"gravity = [0, 0, -10]\n" + ring + "section = {EA = 1, EI = 1, GJ = 1}\n",
       "s.toml:2: gravity needs section.mass_per_length, in kg/m"},
      {"gravity = -10\n" + ring, "s.toml:1: gravity: expected a point [x, y, z], found -10"},
      {"loads = [{rod = 0, s = 17, force = [1, 0, 0]}]\n" + ring,
       "s.toml:1: loads[0].s: expected an arc length from 0 to 16"},
      {"loads = [{rod = 0, s = 1}]\n" + ring, "s.toml:1: the key loads[0].force is missing"},
      {ring + "section = {young = 1}\n",
       "s.toml:3: unknown key rod[0].section.young; known here: shape, radius, youngs_modulus, "
       "poisson, density, EA, EI, GJ"},
      {"anchors = [[0, 0, 0], [1, 0]]\n" + ring,
       "s.toml:1: anchors[1]: expected a point [x, y, z], found an array of 2"},
      {"anchors = [[0, 0, inf]]\n" + ring,
       "s.toml:1: anchors[0][2]: expected a finite number, found inf"},
      {"anchors = [[0, 0, 'a']]\n" + ring,
       "s.toml:1: anchors[0][2]: expected a number, found \"a\""},
      {"anchors = 3\n" + ring, "s.toml:1: anchors: expected an array of points [x, y, z], found 3"},
      {"pinned = [{rod = 1, vertex = 0}]\n" + ring,
       "s.toml:1: pinned[0].rod: there is no rod 1; use 0"},
      {"pinned = [{rod = 0, vertex = 4}]\n" + ring,
       "s.toml:1: pinned[0].vertex: there is no vertex 4; use 0 to 3"},
      {"pinned = [{rod = 0, vertex = -1}]\n" + ring,
       "s.toml:1: pinned[0].vertex: expected a whole number from 0, found -1"},
      {"pinned = [{rod = 0, vertex = 0, axes = 'w'}]\n" + ring,
       "s.toml:1: pinned[0].axes: expected letters of \"xyz\", found \"w\""},
      {"pinned = [{vertex = 0}]\n" + ring, "s.toml:1: the key pinned[0].rod is missing"},
      {"planar = true\n[[rod]]\ncurve = 'tall.csv'\n",
       "s.toml:1: planar: all z coordinates must be the same, but vertex 0 of the rod has z = 0 "
       "and "
       "vertex 2 of the rod has z = 1"},
      {"planar = true\nanchors = [[0, 0, 1]]\n" + ring,
       "s.toml:1: planar: all z coordinates must be the same, but the rods have z = 0 and "
       "anchors[0] has z = 1"},
      {"[[rod]]\ncurve = 'eight.csv'\n",
       "s.toml: the rod crosses itself: 0 and 9.121 cm along the rod are the same point; "
       "move the curves apart there"},
      {ring + "[[rod]]\nfamily = 'circle'\nparameters = {radius = 4}\nvertices = 8\n",
       "s.toml: two rods cross: A at 4 cm and B at 0 cm are the same point; move the curves apart "
       "there"},
      {ring + "[desing]\n", "s.toml:3: unknown key desing; did you mean design?"},
      {"design = 3\n" + ring, "s.toml:1: design: expected a table, found 3"},
      {design + "max_eror = 1\n", "s.toml:4: unknown key design.max_eror; did you mean max_error?"},
      {design + "max_error = -1\n",
       "s.toml:4: design.max_error: expected a positive number, found -1"},
      {design + "max_error = '1 %'\n",
       "s.toml:4: design.max_error: expected a number, found \"1 %\""},
      {design + "max_error = true\n", "s.toml:4: design.max_error: expected a number, found true"},
      {design + "method = 'magic'\n",
       "s.toml:4: design.method: expected one of force-balance, dense-springs, found \"magic\""},
      {design + "optimizer = 'knitro'\n",
       "s.toml:4: design.optimizer: expected one of gauss-newton, ipopt, mma, ccsaq, found "
       "\"knitro\""},
      {design + "optimizer = 'Ipopt'\n",
       "s.toml:4: design.optimizer: expected one of gauss-newton, ipopt, mma, ccsaq, found "
       "\"Ipopt\"; did you mean \"ipopt\"?"},
      {design + "optimizer = ipopt # the usual one\n",
       "s.toml:4: texts are in quotes: optimizer = \"ipopt\""},
      {"[rod]\ncurve = 'ring.obj'\n",
       "s.toml:1: rod: is one table, where there may be several; write [[rod]] for [rod]"},
      {design + "optimizer = 'mma'\nhessian = 'exact'\n",
       "s.toml:5: design.hessian: belongs to the optimizer ipopt or gauss-newton; mma uses "
       "gradients only"},
      {design + "hessian = 'limited-memory'\n",
       "s.toml:4: design.hessian: limited-memory is for ipopt; for gauss-newton use gauss-newton "
       "or exact"},
      {design + "rod_pairs = [[0, 1]]\n", "s.toml:4: design.rod_pairs: there is no rod 1; use 0"},
      {design + "rod_pairs = [[0]]\n",
       "s.toml:4: design.rod_pairs: expected pairs [a, b], found an array of 1"},
      {design + "rod_pairs = [0, 0]\n",
       "s.toml:4: design.rod_pairs[0]: expected an array of whole numbers, found 0"},
      {design + "rod_pairs = []\n",
       "s.toml:4: design.rod_pairs: is empty and there are no cables to anchors, so no cable is "
       "left; "
       "name a pair of rods, such as [0, 0] for cables within rod 0"},
      {design + "external = true\n",
       "s.toml:4: design.external: is true, but the scene has no anchors; add anchors = [[x, y, "
       "z], ...] or frame = {shape = \"cube\"}"},
      {design + "longest_cable = 0\n",
       "s.toml:4: design.longest_cable: expected a positive number, found 0"},
      {design + "sparsity_weights = [0, 10, 1]\n",
       "s.toml:4: design.sparsity_weights: expected increasing numbers that are not negative"},
      {design + "sparsity_weights = []\n",
       "s.toml:4: design.sparsity_weights: expected increasing numbers that are not negative"},
      {design + "threads = 0\n",
       "s.toml:4: design.threads: expected a whole number from 1, found 0"},
      {design + "time = 0\n", "s.toml:4: design.time: expected a positive number, found 0"},
      {design + "effort = 4\n",
       "s.toml:4: design.effort: expected a whole number of at most 3, found 4"},
      {ring + "[edit]\nkeep = [1]\n", "s.toml:3: the key edit.from is missing"},
      {ring + "[edit]\nfrom = 'gone.json'\n",
       "s.toml:4: edit.from: gone.json: there is no such file"},
      {ring + "[edit]\nfrom = 'gone.json'\nforbids = [1]\n",
       "s.toml:5: unknown key edit.forbids; did you mean forbid?"},
      {design + "spring_stiffness = 0\n",
       "s.toml:4: design.spring_stiffness: expected a positive number, found 0"},
      {design + "weights = [{rod = 0, weight = -1}]\n",
       "s.toml:4: design.weights[0].weight: expected a number that is not negative, found -1"},
      {design + "weights = [{rod = 0, weight = 0}]\n",
       "s.toml:4: design.weights: all vertices have weight 0; leave some to be matched"},
      {design + "weights = [{rod = 0, from = 1, weight = 0}]\n",
       "s.toml:4: the key design.weights[0].to is missing"},
      {design + "view = [0, 0, 0]\n",
       "s.toml:4: design.view: expected a direction [x, y, z] that is not zero"},
      {design + "view = [0, 1]\n",
       "s.toml:4: design.view: expected a point [x, y, z], found an array of 2"},
      {design + "view = [[0, 0, 1], [0, 0, 0]]\n",
       "s.toml:4: design.view: views[1]: expected a direction [x, y, z] that is not zero"},
      {design + "view = [{direction = [0, 0, 1], weight = 0}]\n",
       "s.toml:4: design.view[0].weight: expected a positive number, found 0"},
      {design + "view = [{weight = 1}]\n", "s.toml:4: the key design.view[0].direction is missing"},
      {design + "view = [{direction = [0, 0, 0]}]\n",
       "s.toml:4: design.view[0].direction: must not be zero: nothing is seen along it"},
      {"planar = true\n" + design + "view = [0, 0, 1]\n",
       "s.toml:5: design.view: a planar scene is seen along z as it is; leave out view, or planar "
       "where the rods may leave the plane"},
      {design + "forbidden_arcs = [{rod = 0, from = 0, to = 17}]\n",
       "s.toml:4: design.forbidden_arcs[0].to: expected an arc length from 0 to 16"},
      {line + "[design]\nforbidden_arcs = [{rod = 0, from = 1, to = 0.5}]\n",
       "s.toml:4: design.forbidden_arcs[0].from: must not be larger than to on an open rod"},
      {design + "forbidden_vertices = [{rod = 0, vertices = [4]}]\n",
       "s.toml:4: design.forbidden_vertices[0].vertices: there is no vertex 4; use 0 to 3"},
      {design + "forbidden_vertices = [{rod = 0, vertex = 1}]\n",
       "s.toml:4: unknown key design.forbidden_vertices[0].vertex; did you mean vertices?"},
      {design + "spring_stiffness = 1e101\n",
       "s.toml:4: design.spring_stiffness: expected a number of at most 1e100, found 1e+101"},
  };
  for (const Case& bad : cases) {
    CAPTURE(bad.text);
    CHECK(folder.error(bad.text) == bad.error);
  }
  std::string deep = "a";
  for (int i = 0; i < 100'000; ++i) deep += ".a";
  CHECK(folder.error(deep + " = 1\n") ==
        "s.toml:1: a key has more than 50 parts; no scene has such");
  CHECK(folder.local(read_scene(folder / "none.toml").error().text()) ==
        "none.toml: there is no such file");
}

TEST_CASE("no text makes the scene reader throw") {
  const Curves folder;
  const std::string text =
      "anchors = [[20, 0, 0]]\npinned = [{rod = 0, vertex = 2, axes = 'xy'}]\n[[rod]]\n"
      "curve = 'both.obj'\nvertices = 12\nsection = {EA = 3, EI = [2, 1], GJ = 0.5}\n[[rod]]\n"
      "family = 'helix'\nparameters = {turns = 2}\n[design]\nrod_pairs = [[0, 1]]\n"
      "weights = [{rod = 0, from = 1, to = 2, weight = 0}]\n";
  std::mt19937 random(18);
  int read = 0;
  for (int trial = 0; trial < 1000; ++trial) {
    const auto scene = read_scene(folder.put("s.toml", edited(text, trial % 4, random)));
    read += scene ? 1 : 0;
    if (!scene) REQUIRE(scene.error().where.starts_with(folder.path().string()));
  }
  CHECK(read >= 250);
}
