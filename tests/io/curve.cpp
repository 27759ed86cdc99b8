#include <bit>
#include <catch2/catch.hpp>
#include <cstdint>
#include <limits>
#include <random>
#include <tencer/curves/analytic.hpp>
#include <tencer/io/csv.hpp>
#include <tencer/io/curve.hpp>

#include "edited.hpp"
#include "fixtures/folder.hpp"

using tencer::geometry::Polyline;
using tencer::io::read_curve_file;
using tencer::io::read_curves;
using tencer::io::write_obj;

namespace {

std::vector<Polyline> curves_of(const Folder& folder, std::string_view name,
                                std::string_view text) {
  const auto curves = read_curves(folder.put(name, text));
  if (!curves) FAIL(curves.error().text());
  return *curves;
}

Polyline polyline(bool closed, std::initializer_list<Eigen::Vector3d> points) {
  Polyline result{Eigen::Matrix3Xd(3, points.size()), closed};
  int i = 0;
  for (const Eigen::Vector3d& point : points) result.points.col(i++) = point;
  return result;
}

void check_same(const Polyline& found, const Polyline& expected) {
  CHECK(found.closed == expected.closed);
  REQUIRE(found.vertices() == expected.vertices());
  CHECK(found.points == expected.points);
}

const Eigen::Vector3d a(0, 0, 0), b(1, 0, 0), c(1, 1, 0), d(0, 1, 0.5);

// Doubles of every size whose squares are finite, by their bits.
double any_double(std::mt19937_64& random) {
  for (;;) {
    const double value = std::bit_cast<double>(random());
    if (std::abs(value) < 1e100 && std::abs(value) > 1e-100) return value;
  }
}

}  // namespace

TEST_CASE("obj: closed and open lines, comments, negative indices, other keywords") {
  const Folder folder;
  const auto curves = curves_of(folder, "c.obj",
                                "# two rods\n"
                                "o rods\n"
                                "v 0 0 0\nv 1 0 0 1.0\nv 1 1 0\nv 0 1 5e-1 # fourth\n"
                                "\n"
                                "g first\n"
                                "l 1 2 3 4 1\n"
                                "v 0 0 0\r\nv +1 0 0\r\n"
                                "l -2 -1\r\n");
  REQUIRE(curves.size() == 2);
  check_same(curves[0], polyline(true, {a, b, c, d}));
  check_same(curves[1], polyline(false, {a, b}));
}

TEST_CASE("obj: one element an edge is joined to whole curves, in either direction") {
  const Folder folder;
  const std::string vertices = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0.5\n";
  const auto ring = curves_of(folder, "c.obj", vertices + "l 2 3\nl 4 3\nl 4 1\nl 1 2\n");
  REQUIRE(ring.size() == 1);
  check_same(ring[0], polyline(true, {b, c, d, a}));
  const auto chain = curves_of(folder, "c.obj", vertices + "l 2 3\nl 1 2\nl 3/1 4/1\n");
  REQUIRE(chain.size() == 1);
  check_same(chain[0], polyline(false, {a, b, c, d}));
  const auto two = curves_of(folder, "c.obj", vertices + "l 1 2\nl 4 3\n");
  REQUIRE(two.size() == 2);
  check_same(two[1], polyline(false, {d, c}));
}

TEST_CASE("obj: vertices alone are one curve, closed when the last repeats the first") {
  const Folder folder;
  check_same(curves_of(folder, "c.OBJ", "v 0 0 0\nv 1 0 0\nv 1 1 0\n")[0],
             polyline(false, {a, b, c}));
  check_same(curves_of(folder, "c.OBJ", "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 0 0\n")[0],
             polyline(true, {a, b, c}));
}

TEST_CASE("tables: separators, header, comments, blank lines between rods") {
  const Folder folder;
  const auto csv =
      curves_of(folder, "c.csv",
                "\xEF\xBB\xBFx,y,z\r\n0,0,0\r\n1, 0, 0\r\n# comment\r\n1,1,0\r\n0,0,0\r\n"
                "\r\n\r\n0;0;0\r\n1;0;0 # end\r\n");
  REQUIRE(csv.size() == 2);
  check_same(csv[0], polyline(true, {a, b, c}));
  check_same(csv[1], polyline(false, {a, b}));
  const auto xyz = curves_of(folder, "c.xyz", "0 0 0\n1\t0  0\n 1 1 0 \n0 1 .5");
  check_same(xyz[0], polyline(false, {a, b, c, d}));
}

TEST_CASE("json: curves with and without their closed flag, and a bare array") {
  const Folder folder;
  const auto curves = curves_of(folder, "c.json",
                                R"({"curves": [
                             {"closed": true, "points": [[0,0,0],[1,0,0],[1,1,0]]},
                             {"closed": true, "points": [[0,0,0],[1,0,0],[1,1,0],[0,0,0]]},
                             {"points": [[0,0,0],[1,0,0],[1,1,0],[0,0,0]]},
                             {"closed": false, "points": [[0,0,0],[1,0,0]]}]})");
  REQUIRE(curves.size() == 4);
  for (int i = 0; i < 3; ++i) check_same(curves[i], polyline(true, {a, b, c}));
  check_same(curves[3], polyline(false, {a, b}));
  check_same(curves_of(folder, "c.json", "[[0,0,0],[1,0,0],[1,1,0]]")[0],
             polyline(false, {a, b, c}));
}

TEST_CASE("points that repeat the one before them are dropped, and it is said how many") {
  const Folder folder;
  const auto file = read_curve_file(
      folder.put("c.csv", "0,0,0\n0,0,0\n1,0,0\n1,1,0\n1,1,1e-12\n1,1,0\n0,0,0\n0,0,0\n"));
  REQUIRE(file);
  check_same(file->curves[0], polyline(true, {a, b, c}));
  REQUIRE(file->notes.size() == 1);
  CHECK(folder.local(file->notes[0]) ==
        "c.csv:1: 4 points of this curve repeat the one before them and are dropped");
  const auto obj =
      read_curve_file(folder.put("c.obj", "v 0 0 0\nv 1 0 0\nv 1 0 0\nv 1 1 0\nl 1 2 3 4\n"));
  REQUIRE(obj);
  check_same(obj->curves[0], polyline(false, {a, b, c}));
  CHECK(folder.local(obj->notes.at(0)) ==
        "c.obj:5: 1 point of this curve repeats the one before it and is dropped");
}

TEST_CASE("ends that nearly meet are closed, those that are neighbours are told, and others stay") {
  const Folder folder;
  const Polyline ring = tencer::curves::circle(10, 24);
  const auto text = [&](double turn) {
    std::string lines;
    for (const auto& point : ring.points.colwise())
      lines += tencer::io::to_text(point.x()) + " " + tencer::io::to_text(point.y()) + " 0\n";
    if (turn > 0)
      lines += tencer::io::to_text(10 * std::cos(turn)) + " " +
               tencer::io::to_text(10 * std::sin(turn)) + " 0\n";
    return lines;
  };
  const auto nearly = read_curve_file(folder.put("c.xyz", text(1e-3)));
  REQUIRE(nearly);
  check_same(nearly->curves[0], ring);
  CHECK(folder.local(nearly->notes.at(0)) ==
        "c.xyz:1: the ends of this curve are 0.01 apart: it is taken as closed");
  auto open = read_curve_file(folder.put("c.xyz", text(0)));
  REQUIRE(open);
  CHECK_FALSE(open->curves[0].closed);
  CHECK_THAT(open->open_ends.at(0),
             Catch::Contains("this curve is open, with its ends 2.61 apart") &&
                 Catch::Contains("--closed"));
  CHECK_FALSE(tencer::io::close_curve(open->curves[0]));
  check_same(open->curves[0], ring);
  CHECK(read_curve_file(folder.put("c.csv", "0,0,0\n1,0,0\n1,1,0\n0,1,0.5\n"))->open_ends.empty());
  Polyline line = polyline(false, {a, b, {2, 0, 0}, {3, 0, 0}, {4, 0, 0}});
  CHECK_THAT(tencer::io::close_curve(line).value_or(""),
             Catch::StartsWith("the ends of the curve are 4 apart, 4 times its longest edge"));
}

TEST_CASE(
    "tables of other countries and programs: decimal commas, UTF-16, units, continued lines") {
  const Folder folder;
  const Polyline expected = polyline(false, {{0.5, 0, 0}, {1, -1.25, 0}, {1, 1, 3}});
  check_same(curves_of(folder, "c.csv", "0,5;0;0\n1;-1,25;0\n1;1;3\n")[0], expected);
  check_same(curves_of(folder, "c.txt", "0,5 0 0\n1 -1,25 0\n1\t1\t3\n")[0], expected);
  check_same(curves_of(folder, "c.txt", "0.5, 0, 0\n1, -1.25, 0\n1, 1, 3\n")[0], expected);
  for (const bool little : {true, false}) {
    std::string wide = little ? "\xFF\xFE" : "\xFE\xFF";
    for (const char character : std::string("0.5 0 0\r\n1 -1.25 0\r\n1 1 3\r\n"))
      wide += little ? std::string{character, '\0'} : std::string{'\0', character};
    check_same(curves_of(folder, "c.csv", wide)[0], expected);
  }
  check_same(
      curves_of(folder, "c.obj", "v 0.5 0 0\nv 1 \\\n-1.25 0\nv 1 1 3\nl 1 \\\n2 \\ \n 3\n")[0],
      expected);

  const std::string rows = "0,0,0\n1,0,0\n1,1,0\n";
  const auto unit = [&](const std::string& head) {
    return read_curve_file(folder.put("c.csv", head + rows))->length_unit.value_or("none");
  };
  CHECK(unit("x,y,z\n") == "none");
  CHECK(unit("# unit: mm\n") == "mm");
  CHECK(unit("# Units = m\nx,y,z\n") == "m");
  CHECK(unit("X(mm),Y(mm),Z(mm)\n") == "mm");
  CHECK(unit("x [cm], y [cm], z [cm]\n") == "cm");
  CHECK(unit("# points in some order\n") == "none");
}

TEST_CASE("curves that are bad are refused with place and remedy") {
  struct Case {
    const char* name;
    std::string_view text;
    const char* error;
  };
  const Case cases[] = {
      {"c.obj", "v 0 0\n", "c.obj:1: a vertex needs 3 coordinates, found 2"},
      {"c.obj", "v 0 0 0\nv 0 zero 0\n", "c.obj:2: 'zero' is not a number"},
      {"c.obj", "v 0 0 1.0x\n", "c.obj:1: '1.0x' is not a number"},
      {"c.obj", "v 0 0 nan\n", "c.obj:1: 'nan' is not a finite number"},
      {"c.obj", "v 0 -1e101 0\n",
       "c.obj:1: '-1e101' is too large for a coordinate; use a larger unit of length"},
      {"c.obj", "v 0 -inf 0\n", "c.obj:1: '-inf' is not a finite number"},
      {"c.obj", "v 0 0 0\nv 1 0 0\nl 1 3\n",
       "c.obj:3: vertex index 3 is out of range: use 1 to 2, or -1 to -2"},
      {"c.obj", "v 0 0 0\nv 1 0 0\nl 0 1\n", "c.obj:3: vertex index 0: OBJ counts from 1"},
      {"c.obj", "v 0 0 0\nl 1 -2\n",
       "c.obj:2: vertex index -2 is out of range: use 1 to 1, or -1 to -1"},
      {"c.obj", "l 1 2\n",
       "c.obj:1: vertex index 1 is out of range: there are no vertices before this line"},
      {"c.obj", "v 0 0 0\nl 1 b\n", "c.obj:2: 'b' is not a vertex index"},
      {"c.obj", "v 0 0 0\nl 1\n",
       "c.obj:2: a line element needs at least 2 vertex indices, found 1"},
      {"c.obj", "v 0 0 0\n", "c.obj: a curve needs at least 2 points, found 1"},
      {"c.obj", "", "c.obj: the file holds no vertices (v x y z)"},
      {"c.obj", "vertex 0 0 0\n",
       "c.obj:1: unknown keyword 'vertex'; curves are given by v (vertex) and l (line) elements"},
      {"c.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 1\nf 1 2 3\nf 2 3 4\n",
       "c.obj:6: the file holds a mesh, faces that share vertices, and no curves; curves are given "
       "by l (line) elements, or each by one face of its own"},
      {"c.obj", "v 0 0 0\nv 1 0 0\nv 2 1 0\nv 2 -1 0\nl 1 2\nl 2 3\nl 2 4\n",
       "c.obj:7: three line elements end at vertex 2; a rod cannot branch, so give each rod its "
       "own "
       "vertices"},
      {"c.obj", "v 0 0 0\nv 1 0 0\nl 1 2 1\n",
       "c.obj:3: a closed curve needs at least 3 different points, found 2"},
      {"c.obj", "v 0 0 0\nv 1 0 0\ncstype bspline\ndeg 3\ncurv 0 1 1 2\n",
       "c.obj:5: this curve cannot be drawn: it has too few control points for its degree"},
      {"c.obj", "cstype cardinal\n",
       "c.obj:1: a curve of type 'cardinal' is not read, only bspline and bezier; convert it to "
       "lines before export"},
      {"c.obj", "v 0 0 0\nv 1 0 0\nv 2 0 0\nv 1.5 0 0\n",
       "c.obj: the curve turns straight back at vertex 3, where no elastic rod can follow; remove "
       "this point or move it"},
      {"c.csv", "x,y,z\n0,0,0\n1,0,0\nx,y,z\n", "c.csv:4: 'x' is not a number"},
      {"c.csv", "0,0,0\n1,0\n", "c.csv:2: expected 3 numbers x, y, z, found 2 fields"},
      {"c.csv", "0,5,0,0,1,0\n",
       "c.csv:1: expected 3 numbers x, y, z, found 6 fields; where commas are decimal, separate "
       "the "
       "numbers by semicolons"},
      {"c.csv", "1,0,0,0\n",
       "c.csv:1: expected 3 numbers x, y, z, found 4 fields; name the columns in a first line, "
       "such "
       "as x, y, z, others"},
      {"c.csv", "0,0,0\n1,,0\n", "c.csv:2: '' is not a number"},
      {"c.csv", "0,0,0\n1 2,0,0\n", "c.csv:2: '1 2' is not a number"},
      {"c.csv", "0,0,0\n1,0,NaN\n", "c.csv:2: 'NaN' is not a finite number"},
      {"c.csv", "0,0,0\n1,0,1e999\n", "c.csv:2: '1e999' is not a number"},
      {"c.csv", "0,0,0\n\n1,0,0\n2,0,0\n", "c.csv:1: a curve needs at least 2 points, found 1"},
      {"c.csv", "0,0,0\n0,0,0\n", "c.csv:1: a curve needs at least 2 different points, found 1"},
      {"c.csv", std::string_view("0,0,0\n1\0,0,0\n", 14),
       "c.csv: is not text: it holds NUL bytes; save it as plain text, in UTF-8"},
      {"c.csv", "# nothing\n",
       "c.csv: the file holds no points; expected lines of 3 numbers x, y, z"},
      {"c.xyz", "3\ntrefoil\n0 0 0\n",
       "c.xyz:1: expected 3 numbers x, y, z, found 1 field; of an XYZ file of atoms drop the "
       "count, the "
       "line after it and the elements, so that three numbers are left on each line"},
      {"c.xyz", "C 0 0 0\nC 1 0 0\n",
       "c.xyz:1: expected 3 numbers x, y, z, found 4 fields; drop the word before the three "
       "numbers "
       "of each line"},
      {"c.json", "[[0,0],[1,0,0]]", "c.json: [1]: expected a point [x, y], like the first"},
      {"c.json", "{\"type\": \"Feature\", \"geometry\": {}}",
       "c.json: is GeoJSON, a map in degrees; project it to metres and save the points as CSV, "
       "x,y,z a line"},
      {"c.json", "{\"x\": [1], \"y\": [1, 2]}",
       "c.json: x, y and z must be equally many; found 1, 2 and 1"},
      {"c.json", "{\"curves\": [\n{\"points\": [[0,0,0],\n[1,0,NaN]]}]}",
       "c.json:3: is not valid JSON: syntax error while parsing value - invalid literal; last "
       "read: '0,N'"},
      {"c.json", "[[0,0,0],[1,0,1e999]]",
       "c.json: is not valid JSON: number overflow parsing '1e999'"},
      {"c.json", "[[0,0,0],[1,0,1e200]]",
       "c.json: [1][2]: expected a number of at most 1e100, found 1e+200"},
      {"c.json", "{\"curves\": 3}", "c.json: curves: expected an array, found 3"},
      {"c.json", "{\"curves\": []}", "c.json: curves: holds no curves"},
      {"c.json", "{\"curve\": []}", "c.json: the key \"curves\" is missing"},
      {"c.json", "3", "c.json: expected {\"curves\": [...]} or an array of points [x, y, z]"},
      {"c.json", "{\"curves\": [{\"close\": true, \"points\": []}]}",
       "c.json: curves[0]: unknown key close; did you mean closed?"},
      {"c.json", "{\"curves\": [{\"closed\": 1, \"points\": []}]}",
       "c.json: curves[0].closed: expected true or false, found 1"},
      {"c.json", "[[0,0,0],[1,0]]", "c.json: [1]: expected a point [x, y, z], found an array of 2"},
      {"c.json", "{\"curves\": [{\"points\": [[0,0,0],[1,\"0\",0]]}]}",
       "c.json: curves[0].points[1][1]: expected a number, found \"0\""},
      {"c.json", "{\"curves\": [{\"points\": [[0,0,0]]}]}",
       "c.json: curves[0].points: a curve needs at least 2 points, found 1"},
      {"c.json", "{\"curves\": [{\"closed\": true, \"points\": [[0,0,0],[1,0,0]]}]}",
       "c.json: curves[0].points: a closed curve needs at least 3 different points, found 2"},
      {"c.json",
       "{\"curves\": [{\"closed\": false, \"points\": [[0,0,0],[1,0,0],[1,1,0],[0,0,0]]}]}",
       "c.json: curves[0].points: closed is false, but the last point repeats the first; set "
       "closed "
       "to true, or remove the last point"},
      {"c.json",
       "{\"curves\": [{\"closed\": false, \"points\": [[0,0,0],[1,0,0],[1,1,0],[0,0,0.001]]}]}",
       "c.json: curves[0].points: closed is false, but the ends are 0.001 apart, less than 1 % of "
       "an "
       "edge; set closed to true, or move them apart"},
      {"c.stl", "solid",
       "c.stl: is a mesh and holds no curves; save the curve itself as OBJ or CSV"},
  };
  const Folder folder;
  for (const Case& bad : cases) {
    CAPTURE(bad.name, bad.text);
    const auto curves = read_curves(folder.put(bad.name, bad.text));
    REQUIRE_FALSE(curves);
    CHECK(folder.local(curves.error().text()) == bad.error);
  }
  CHECK(folder.local(read_curves(folder / "none.obj").error().text()) ==
        "none.obj: there is no such file");
}

TEST_CASE("no text makes a reader throw, whatever it is cut to") {
  const Folder folder;
  const std::string obj = "v 0 0 0\nv 1 0 0\nv 1 1 0\nl 1 2 3 -3\nl -1/2 1\n";
  const std::string csv = "x;y;z\n0;0;0\n1;0;0\n\n1e5 2 3\n,,\n";
  const std::string json = R"({"curves": [{"closed": true, "points": [[0,0,0],[1,0,0],[1,1]]}]})";
  const std::string nurbs =
      "v 0 0 0\nv 1 0 0 2\nv 1 1 0\ncstype rat bspline\ndeg 2\ncurv 0 1 1 2 3\nparm u 0 0 0 1 1 "
      "1\n";
  const std::string vect = "VECT\n2 5 0\n-3 2\n0 0\n0 0 0 1 0 0 1 1 0\n0 0 1\n1 0 1\n";
  const std::string svg =
      "<svg width='9mm' viewBox='0 0 9 9'><g transform='rotate(9) skewX(2)'><circle r='3'/>"
      "<path d='M0 0C1 0 1 1 2 1A3 2 10 0 1 8 8h1z'/></g></svg>";
  const std::string dxf =
      "0\nSECTION\n2\nENTITIES\n0\nLWPOLYLINE\n70\n1\n10\n0\n20\n0\n42\n1\n10\n3\n20\n0\n0\nSPLINE"
      "\n71\n1\n40\n0\n40\n0\n40\n1\n40\n1\n10\n0\n20\n5\n10\n1\n20\n6\n0\nSPLINE\n11\n0\n21\n9\n11"
      "\n"
      "1\n21\n9\n11\n2\n21\n8\n0\nARC\n10\n20\n40\n1\n51\n90\n0\nENDSEC\n";
  std::mt19937 random(15);
  for (const auto& [name, text] :
       {std::pair("c.obj", obj), std::pair("c.csv", csv), std::pair("c.json", json),
        std::pair("n.obj", nurbs), std::pair("c.vect", vect), std::pair("c.svg", svg),
        std::pair("c.dxf", dxf)})
    for (int trial = 0; trial < 500; ++trial) {
      const std::size_t cut = random() % (text.size() + 1);
      const auto curves = read_curves(folder.put(name, edited(text, 3, random).substr(0, cut)));
      if (curves) {
        for (const Polyline& curve : *curves)
          REQUIRE(tencer::geometry::edge_lengths(curve).minCoeff() > 0);
      } else {
        REQUIRE_FALSE(curves.error().message.empty());
        REQUIRE(curves.error().where.starts_with(folder.path().string()));
      }
    }
}

TEST_CASE("obj files give every double back") {
  const Folder folder;
  std::mt19937_64 random(16);
  std::uniform_real_distribution<double> uniform(-1, 1);
  std::vector<Polyline> curves = tencer::curves::twin_trefoils(27, 10.8, 102);
  curves[1].closed = false;
  for (double& x : curves[0].points.reshaped()) x += uniform(random);
  REQUIRE_FALSE(write_obj(folder / "c.obj", curves));
  const auto again = read_curves(folder / "c.obj");
  REQUIRE(again);
  REQUIRE(again->size() == 2);
  for (int i = 0; i < 2; ++i) check_same((*again)[i], curves[i]);

  // Two points of any size; a third would almost surely be a zero-length edge next to it.
  for (int trial = 0; trial < 200; ++trial) {
    Polyline pair{Eigen::Matrix3Xd(3, 2), false};
    for (double& x : pair.points.reshaped()) x = any_double(random);
    REQUIRE_FALSE(write_obj(folder / "c.obj", std::vector{pair}));
    const auto read_pair = read_curves(folder / "c.obj");
    if (!read_pair) FAIL(read_pair.error().text());
    for (int i = 0; i < 6; ++i)
      REQUIRE(std::bit_cast<std::uint64_t>(read_pair->at(0).points.data()[i]) ==
              std::bit_cast<std::uint64_t>(pair.points.data()[i]));
  }
}
