// Curves as other programs write them.
#include <catch2/catch.hpp>
#include <numbers>
#include <tencer/geometry/measure.hpp>
#include <tencer/io/curve.hpp>

#include "fixtures/folder.hpp"

using namespace tencer;
using geometry::Polyline;

namespace {

io::CurveFile file_of(const Folder& folder, std::string_view name, std::string_view text) {
  const auto file = io::read_curve_file(folder.put(name, text));
  if (!file) FAIL(file.error().text());
  return *file;
}

std::string error(const Folder& folder, std::string_view name, std::string_view text) {
  const auto file = io::read_curve_file(folder.put(name, text));
  return file ? "none" : folder.local(file.error().text());
}

double length(const Polyline& curve) { return geometry::edge_lengths(curve).sum(); }

// Of the longest edge to the shortest.
double evenness(const Polyline& curve) {
  const auto lengths = geometry::edge_lengths(curve);
  return lengths.maxCoeff() / lengths.minCoeff();
}

void check_circle(const Polyline& curve, const Eigen::Vector3d& center, double radius) {
  CHECK(curve.closed);
  CHECK(curve.vertices() >= 60);
  CHECK(length(curve) == Approx(2 * std::numbers::pi * radius).epsilon(1e-3));
  for (const auto& point : curve.points.colwise())
    CHECK((point - center).norm() == Approx(radius).epsilon(1e-9));
}

std::string dxf(const std::string& entities, const std::string& units = "4") {
  return "0\nSECTION\n2\nHEADER\n9\n$INSUNITS\n70\n" + units +
         "\n0\nENDSEC\n0\nSECTION\n2\nENTITIES\n" + entities + "0\nENDSEC\n0\nEOF\n\n\n\n";
}

std::string dxf_line(double x0, double y0, double x1, double y1) {
  const auto pair = [](int code, double x) {
    return std::to_string(code) + "\n" + std::to_string(x) + "\n";
  };
  return "0\nLINE\n8\n0\n" + pair(10, x0) + pair(20, y0) + pair(11, x1) + pair(21, y1);
}

}  // namespace

TEST_CASE("obj: NURBS curves, as Rhino and Blender write them") {
  const Folder folder;
  // A quarter of a circle, exactly.
  const auto quarter =
      file_of(folder, "c.obj",
              "v 1 0 0 1\nv 1 1 0 0.70710678118654752\nv 0 1 0 1\ncstype rat bspline\n"
              "deg 2\ncurv 0 1 1 2 3\nparm u 0 0 0 \\\n1 1 1\nend\n");
  REQUIRE(quarter.curves.size() == 1);
  for (const auto& point : quarter.curves[0].points.colwise()) CHECK(point.norm() == Approx(1));
  CHECK(length(quarter.curves[0]) == Approx(std::numbers::pi / 2).epsilon(1e-3));
  CHECK(evenness(quarter.curves[0]) < 1.1);

  // A cyclic one: its control points go round and its knots go beyond what it is defined in.
  std::string cyclic = "o Nurbs\n";
  for (const char* point : {"1 0", "0 1", "-1 0", "0 -1"})
    cyclic += "v " + std::string(point) + " 0\n";
  cyclic += "g Nurbs\ncstype bspline\ndeg 3\ncurv 0.0 1.0 -4 -3 -2 -1 -4 -3 -2\nparm u";
  for (int i = 0; i <= 10; ++i) cyclic += " " + std::to_string(i / 10.0);
  const auto ring = file_of(folder, "c.obj", cyclic + "\nend\n");
  CHECK(ring.curves.at(0).closed);
  CHECK(ring.curves[0].points.colwise().norm().minCoeff() > 0.6);
  CHECK(length(ring.curves[0]) == Approx(2 * std::numbers::pi * 2 / 3).epsilon(0.02));

  const auto bezier = file_of(folder, "c.obj",
                              "v 0 0 0\nv 1 2 0\nv 2 0 0\nv 3 -2 0\nv 4 0 0\ncstype bezier\ndeg 2\n"
                              "curv 0 2 1 2 3 4 5\nparm u 0 1 2\nend\n");
  CHECK(bezier.curves.at(0).points.rightCols(1) == Eigen::Vector3d(4, 0, 0));
  CHECK(bezier.curves[0].points.row(1).maxCoeff() == Approx(1).epsilon(1e-3));
}

TEST_CASE("obj: a face of its own is a closed curve") {
  const Folder folder;
  const auto file =
      file_of(folder, "c.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1/1 2/2 3/3 4/4\n");
  REQUIRE(file.curves.size() == 1);
  CHECK(file.curves[0].closed);
  CHECK(file.curves[0].vertices() == 4);
}

TEST_CASE("tables: headers that name columns, two columns, quotes, comments, units") {
  const Folder folder;
  const auto named =
      file_of(folder, "c.csv",
              "\"id\",\"x [in]\",\"y [in]\",\"z [in]\"\r\n1,\"0\",0,1\r\n2,1,0,1\r\n3,1,1,1\r\n");
  CHECK(named.length_unit == "in");
  CHECK(named.curves[0].points.col(2) == Eigen::Vector3d(1, 1, 1));
  const auto paraview =
      file_of(folder, "c.csv", "\"Points:0\";\"Points:1\";\"Points:2\"\n0;0;1\n1;0;1\n");
  CHECK(paraview.curves[0].points.col(1) == Eigen::Vector3d(1, 0, 1));
  const auto plane =
      file_of(folder, "c.tsv", "% made by hand\n// in the plane\n0\t0\n1\t0,5\n2\t0\n");
  CHECK(plane.curves[0].points.col(1) == Eigen::Vector3d(1, 0.5, 0));
  CHECK(folder.local(plane.notes.at(0)) == "c.tsv:3: two numbers a line: z is taken as 0");
  CHECK_FALSE(file_of(folder, "c.csv", "x,y,z,m\n0,0,0,1\n1,0,0,1\n").length_unit);
  CHECK(file_of(folder, "c.csv", "x_mm,y_mm\n0,0\n1,0\n").length_unit == "mm");
}

TEST_CASE("json: points of other programs") {
  const Folder folder;
  const Eigen::Vector3d last(1, 1, 2);
  for (const char* text :
       {R"([{"x": 0, "y": 0, "z": 0}, {"x": 1, "y": 0, "z": 0}, {"x": 1, "y": 1, "z": 2}])",
        R"({"points": [[0,0,0],[1,0,0],[1,1,2]]})", R"([[[0,0,0],[1,0,0],[1,1,2]]])",
        R"({"x": [0, 1, 1], "y": [0, 0, 1], "z": [0, 0, 2]})",
        R"([{"vertices": [[0,0,0],[1,0,0],[1,1,2]], "closed": false}])",
        R"({"curves": [[[0,0,0],[1,0,0],[1,1,2]]]})"})
    CHECK(file_of(folder, "c.json", text).curves.at(0).points.col(2) == last);
  const auto closed =
      file_of(folder, "c.json", R"({"closed": true, "units": "m", "points": [[0,0],[1,0],[1,1]]})");
  CHECK(closed.curves[0].closed);
  CHECK(closed.length_unit == "m");
}

TEST_CASE("Geomview VECT: closed where the count is negative") {
  const Folder folder;
  const std::string two = "VECT # two\n2 6 0\n-3 3\n0 0\n0 0 0 1 0 0 1 1 0\n0 0 1\n1 0 1\n1 1 1\n";
  const auto file = file_of(folder, "c.vect", two);
  REQUIRE(file.curves.size() == 2);
  CHECK(file.curves[0].closed);
  CHECK_FALSE(file.curves[1].closed);
  CHECK(file_of(folder, "c.txt", two).curves.size() == 2);  // told by its first word
  CHECK(
      error(folder, "c.vect", "4VECT\n1 2 0\n") ==
      "c.vect:1: 4VECT has points in four dimensions; project them and save the three coordinates "
      "as VECT");
  CHECK(error(folder, "c.vect", "VECT\n1 3 0\n3\n0\n0 0 0 1 0\n") ==
        "c.vect: the file ends where a coordinate should follow");
  CHECK(error(folder, "c.vect", "VECT\n1 3 0\n2\n0\n") ==
        "c.vect: the polylines have 2 vertices, but the second line says 3");
}

TEST_CASE("svg: every command of a path") {
  const Folder folder;
  const auto path = [&](const std::string& d) {
    return file_of(folder, "c.svg",
                   "<svg xmlns='http://www.w3.org/2000/svg'><path d='" + d + "'/></svg>")
        .curves.at(0);
  };
  // Lines as they are drawn, y up.
  const Polyline square = path("m1 1h2v2H1z");
  CHECK(square.closed);
  REQUIRE(square.vertices() == 4);
  CHECK(square.points.col(2) == Eigen::Vector3d(3, -3, 0));
  CHECK(path("M0,0 10-5.5.5 3").points.col(2) == Eigen::Vector3d(.5, -3, 0));
  // Two half circles; flags without blanks between them.
  check_circle(path("M-2 0A2 2 0 0 1 2 0a2,2 0 01-4,0Z"), {0, 0, 0}, 2);
  check_circle(path("M-2 0A1 1 0 1 0 2 0A1 1 0 1 0-2 0Z"), {0, 0, 0}, 2);  // grown to reach
  // The smooth forms go on as the curves before them.
  const Polyline cubic = path("M0 0C0 1 1 1 1 0S2-1 2 0");
  CHECK((cubic.points - path("M0 0C0 1 1 1 1 0C1-1 2-1 2 0").points).norm() < 1e-12);
  const Polyline quadratic = path("M0 0Q1 2 2 0T4 0");
  CHECK((quadratic.points - path("m0 0q1 2 2 0q1-2 2 0").points).norm() < 1e-12);
  CHECK(quadratic.points.row(1).maxCoeff() == Approx(1).epsilon(1e-2));
  CHECK(evenness(quadratic) < 1.2);
}

TEST_CASE("svg: shapes, transforms, units; what is no curve is left out") {
  const Folder folder;
  const auto file = file_of(folder, "c.svg", R"svg(<?xml version="1.0"?>
<svg width="200mm" height="100mm" viewBox="0 0 100 50">
  <defs><path d="M0 0 L9 9"/></defs>
  <g transform="translate(10 20) scale(2)"><g transform="rotate(90)">
    <circle cx="3" cy="1" r="4"/>
  </g></g>
  <rect x="1" y="1" width="20" height="10" rx="2"/>
  <polyline points="50,0 60,0 60,10"/><polygon points="70 0 80 0 80 10"/>
  <line x1="90" y1="1" x2="99" y2="1"/><ellipse cx="50" cy="30" rx="5" ry="3"/>
  <path d="M0 0L1 1" style="display:none"/>
  <text>no curve</text>
</svg>)svg");
  REQUIRE(file.curves.size() == 6);
  CHECK(file.length_unit == "mm");
  check_circle(file.curves[0], {16, -52, 0}, 16);
  CHECK(file.curves[1].closed);
  CHECK(length(file.curves[1]) ==
        Approx(2 * (2 * 16 + 2 * 6 + 4 * std::numbers::pi)).epsilon(1e-3));
  CHECK(evenness(file.curves[1]) < 2);
  CHECK_FALSE(file.curves[2].closed);
  CHECK(file.curves[3].closed);
  CHECK(folder.local(file.notes.back()) ==
        "c.svg: text, pictures and copies of other files are left out, 1 of them");
}

TEST_CASE("svg: copies are drawn where they are put") {
  const Folder folder;
  const auto file = file_of(folder, "c.svg", R"svg(<svg xmlns:xlink="http://www.w3.org/1999/xlink">
  <defs><circle id="dot" cx="1" cy="0" r="2"/>
    <g id="pair"><use href="#dot"/><use xlink:href="#dot" x="10"/></g></defs>
  <symbol id="mark"><path d="M0 0L3 0"/></symbol>
  <use href="#pair" transform="translate(0 5) scale(2)"/>
  <use href="#mark" x="1" y="2"/>
  <use href="#none"/><use href="other.svg#dot"/>
</svg>)svg");
  REQUIRE(file.curves.size() == 3);
  check_circle(file.curves[0], {2, -5, 0}, 4);
  check_circle(file.curves[1], {22, -5, 0}, 4);
  CHECK(file.curves[2].points.col(1) == Eigen::Vector3d(4, -2, 0));
  CHECK(folder.local(file.notes.back()) ==
        "c.svg: text, pictures and copies of other files are left out, 2 of them");
}

TEST_CASE("svg: what is wrong is said with its line") {
  const Folder folder;
  const auto wrong = [&](const std::string& inside) {
    return error(folder, "c.svg", "<svg>\n" + inside + "</svg>");
  };
  CHECK(wrong("<path d='L1 1'/>") == "c.svg:2: path: a path begins with M, a point to start from");
  CHECK(wrong("<path d='M0 0 L1'/>") == "c.svg:2: path: ends where a number should follow");
  CHECK(wrong("<path d='M0 0 B1 1'/>") ==
        "c.svg:2: path: unknown command 'B'; use M L H V C S Q T A Z");
  CHECK(wrong("<path d='M0 0 L1 x'/>") == "c.svg:2: path: expected a number, found 'x'");
  CHECK(wrong("<g transform='turn(1)'><path/></g>") ==
        "c.svg:2: g: unknown transform 'turn' of 1 numbers");
  CHECK(wrong("<polygon points='1 2 3'/>") ==
        "c.svg:2: polygon: expected pairs of numbers, found 3 numbers");
  CHECK(wrong("<text/>") ==
        "c.svg: the drawing holds no paths or shapes, only text, pictures or copies of other "
        "files; convert these to paths before export");
  CHECK(wrong("<g id='a'><use href='#a'/></g>").find("nested more than 200 deep") !=
        std::string::npos);
  // Each copies the one before ten times.
  std::string many = "<defs><path id='a0' d='M0 0L1 0'/>";
  for (int i = 1; i < 9; ++i) {
    many += "<g id='a" + std::to_string(i) + "'>";
    for (int k = 0; k < 10; ++k) many += "<use href='#a" + std::to_string(i - 1) + "'/>";
    many += "</g>";
  }
  CHECK(wrong(many + "</defs><use href='#a8'/>").find("more than 10000 copies") !=
        std::string::npos);
  CHECK(wrong("<path d='M0 0L1 0M1 1L1 0'/><path d='M1 0L1-1'/>") ==
        "c.svg:2: path: three lines end at (1, 0); a rod cannot branch, so leave out all but the "
        "rods");
  CHECK(error(folder, "c.svg", "<svg><path></svg>") ==
        "c.svg:1: is not valid XML: Start-end tags mismatch");
  std::string deep;
  for (int i = 0; i < 100'000; ++i) deep += "<g>";
  CHECK(wrong(deep).find("groups are nested more than 200 deep") == std::string::npos);  // no XML
  std::string ends = deep;
  for (int i = 0; i < 100'000; ++i) ends += "</g>";
  CHECK_THAT(wrong(ends), Catch::Contains("groups are nested more than 200 deep"));
}

TEST_CASE("dxf: lines and arcs are joined end to end, in any order and direction") {
  const Folder folder;
  // A stadium: two lines and two half circles.
  const std::string arcs =
      "0\nARC\n10\n4\n20\n0\n40\n1\n50\n270\n51\n90\n0\nARC\n10\n0\n20\n0\n40\n1\n50\n90\n51\n270"
      "\n";
  const auto file =
      file_of(folder, "c.dxf", dxf(dxf_line(0, 1, 4, 1.00001) + arcs + dxf_line(0, -1, 4, -1)));
  REQUIRE(file.curves.size() == 1);
  CHECK(file.curves[0].closed);
  CHECK(file.length_unit == "mm");
  CHECK(length(file.curves[0]) == Approx(8 + 2 * std::numbers::pi).epsilon(1e-3));
  CHECK(evenness(file.curves[0]) < 1.2);
}

TEST_CASE("dxf: every kind of curve") {
  const Folder folder;
  const auto one = [&](const std::string& entity) {
    const auto file = file_of(folder, "c.dxf", dxf(entity, "0"));
    CHECK_FALSE(file.length_unit);
    REQUIRE(file.curves.size() == 1);
    return file.curves[0];
  };
  check_circle(one("0\nCIRCLE\n10\n1\n20\n2\n30\n3\n40\n5\n"), {1, 2, 3}, 5);
  // Bulges of 1 are half circles.
  check_circle(
      one("0\nLWPOLYLINE\n90\n2\n70\n1\n38\n3\n10\n-2\n20\n0\n42\n1\n10\n2\n20\n0\n42\n1\n"),
      {0, 0, 3}, 2);
  check_circle(one("0\nPOLYLINE\n66\n1\n70\n1\n0\nVERTEX\n10\n-2\n20\n0\n42\n-1\n0\nVERTEX\n10\n2\n"
                   "20\n0\n42\n-1\n0\nSEQEND\n"),
               {0, 0, 0}, 2);
  check_circle(one("0\nELLIPSE\n10\n0\n20\n0\n11\n0\n21\n3\n40\n1\n41\n0\n42\n6.283185307179586\n"),
               {0, 0, 0}, 3);
  // Seen from below, x is mirrored.
  check_circle(one("0\nCIRCLE\n10\n1\n20\n2\n40\n5\n210\n0\n220\n0\n230\n-1\n"), {-1, 2, 0}, 5);
  const Polyline spline =
      one("0\nSPLINE\n70\n8\n71\n2\n40\n0\n40\n0\n40\n0\n40\n1\n40\n1\n40\n1\n10\n0\n20\n0\n30\n0\n"
          "10\n1\n20\n2\n30\n0\n10\n2\n20\n0\n30\n0\n");
  CHECK(spline.points.row(1).maxCoeff() == Approx(1).epsilon(1e-3));
  CHECK_FALSE(spline.closed);
  CHECK(one("0\nSPLINE\n71\n3\n11\n0\n21\n0\n31\n0\n11\n1\n21\n1\n31\n0\n11\n2\n21\n0\n31\n1\n")
            .points.rightCols(1) == Eigen::Vector3d(2, 0, 1));
}

TEST_CASE("dxf: blocks are drawn where they are inserted") {
  const Folder folder;
  const std::string blocks =
      "0\nSECTION\n2\nBLOCKS\n0\nBLOCK\n2\nA\n10\n1\n20\n0\n0\nCIRCLE\n10\n3\n20\n0\n40\n1\n0\nENDB"
      "LK\n"
      "0\nBLOCK\n2\nB\n0\nINSERT\n2\nA\n10\n0\n20\n5\n0\nENDBLK\n"
      "0\nBLOCK\n2\nC\n0\nINSERT\n2\nC\n0\nENDBLK\n0\nENDSEC\n";
  // Turned by a quarter and twice as large; nested; in two columns.
  const auto file =
      file_of(folder, "c.dxf",
              blocks + dxf("0\nINSERT\n2\nA\n10\n10\n20\n0\n41\n2\n42\n2\n43\n2\n50\n90\n"
                           "0\nINSERT\n2\nB\n10\n0\n20\n20\n70\n2\n44\n30\n"));
  REQUIRE(file.curves.size() == 3);
  check_circle(file.curves[0], {10, 4, 0}, 2);
  check_circle(file.curves[1], {2, 25, 0}, 1);
  check_circle(file.curves[2], {32, 25, 0}, 1);
  CHECK(error(folder, "c.dxf", blocks + dxf("0\nINSERT\n2\nC\n")).find("in themselves") !=
        std::string::npos);
}

TEST_CASE("dxf: what is wrong is said") {
  const Folder folder;
  CHECK(
      error(folder, "c.dxf", "hello\nworld\n") ==
      "c.dxf:1: expected the number of a DXF group, found 'hello'; save it as DXF in text (ASCII) "
      "form");
  CHECK(error(folder, "c.dxf", dxf("0\nINSERT\n2\nA\n")) ==
        "c.dxf: the drawing holds no lines, arcs, polylines or splines, only other things; export "
        "the "
        "curves themselves");
  CHECK(error(folder, "c.dxf", dxf("0\nCIRCLE\n40\n-1\n")) ==
        "c.dxf:16: CIRCLE: expected a positive radius");
  CHECK(error(folder, "c.dxf", dxf("0\nLINE\n10\nx\n")) == "c.dxf:16: LINE: 'x' is not a number");
}

TEST_CASE("files of other kinds are refused with what to do") {
  const Folder folder;
  CHECK(error(folder, "c.vtp", "") ==
        "c.vtp: is of ParaView; there choose File, Save Data, and save the points as CSV");
  CHECK(
      error(folder, "c.geojson", "{}") ==
      "c.geojson: is of a map, in degrees; project it to metres and save the points as CSV, x,y,z "
      "a line");
  CHECK(error(folder, "c.foo", "0 0 0\n") ==
        "c.foo: unknown kind of curve file '.foo'; use one of .obj, .csv, .xyz, .txt, .tsv, .dat, "
        ".pts, .json, .vect, .vec, .svg, .dxf");
  CHECK(file_of(folder, "c.foo", "v 0 0 0\nv 1 0 0\n").curves.size() == 1);
}

TEST_CASE("inches and feet become cm") {
  io::CurveFile file{.curves = {Polyline{Eigen::Matrix3Xd::Identity(3, 3), true}}};
  io::take_unit(file, "in");
  CHECK(file.length_unit == "cm");
  CHECK(file.curves[0].points(0, 0) == 2.54);
}
