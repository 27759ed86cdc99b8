#include <bit>
#include <catch2/catch.hpp>
#include <cstdint>
#include <functional>
#include <limits>
#include <random>
#include <tencer/io/design.hpp>

#include "edited.hpp"
#include "fixtures/folder.hpp"

using namespace tencer;
using namespace tencer::io;
using namespace tencer::model;

namespace {

constexpr double no_number = std::numeric_limits<double>::quiet_NaN();

// A closed rod of 4 vertices, an open one of 3, two anchors, one cable of each kind; numbers whose
// digits need the full precision.
Design sample() {
  Design design;
  design.name = "two \"rods\"";
  design.status = DesignStatus::tolerance_not_reached;
  design.length_unit = "mm";
  std::mt19937_64 random(17);
  std::uniform_real_distribution<double> uniform(0.1, 1.0);
  const auto number = [&] { return uniform(random); };
  Structure& structure = design.structure;
  for (const bool closed : {true, false}) {
    const int n = closed ? 4 : 3;
    const int edges = closed ? n : n - 1;
    structure.rods.push_back({.closed = closed,
                              .section = {.EA = 1e7 * number(),
                                          .EI1 = number(),
                                          .EI2 = number(),
                                          .GJ = 1e-300 * number()},
                              .rest_lengths = Eigen::VectorXd::NullaryExpr(edges, number)});
    design.target.emplace_back(Eigen::Matrix3Xd::NullaryExpr(3, n, number));
    design.pose.emplace_back(Eigen::Matrix3Xd::NullaryExpr(3, n, number));
  }
  design.pose[0](0, 0) = -0.0;
  der::Rod& closed = structure.rods[0];
  closed.closing_angle = number();
  closed.rest_curvature = Eigen::Matrix2Xd::NullaryExpr(2, 4, number);
  closed.rest_twist = Eigen::VectorXd::NullaryExpr(4, number);
  design.target_directors = {Eigen::Matrix3Xd::NullaryExpr(3, 4, number), Eigen::Matrix3Xd(3, 0)};
  design.pose_directors = {Eigen::Matrix3Xd(3, 0), Eigen::Matrix3Xd::NullaryExpr(3, 2, number)};
  structure.point_loads = {{1, 0.0, {number(), -number(), number()}}};
  structure.line_loads = {{0, {0, 0, -number()}}, {1, {0, 0, -number()}}};
  structure.anchors = Eigen::Matrix3Xd::NullaryExpr(3, 2, number);
  structure.pins = {{0, 3, {true, false, true}}, {1, 0, {true, true, true}}};
  structure.cables.push_back(
      {.a = springs::OnRod{0, closed.length()}, .b = springs::OnRod{1, 0.0}});
  design.built.push_back({.length = number(), .tension = number()});
  structure.cables.push_back({.a = springs::OnRod{1, number() / 10},
                              .b = springs::AtAnchor{1},
                              .stiffness = number(),
                              .rest_length = 0.0});
  design.built.push_back({.length = number(), .tension = -number()});
  structure.planar = true;
  design.error = DesignError{number(), number()};
  design.certificate = Certificate{.residual = 1e-12 * number(),
                                   .smallest_eigenvalue = -number(),
                                   .slack_cables = 1,
                                   .stable = false,
                                   .off_by_errors = 0.25,
                                   .settles_from_target = false};
  design.trace = {{"prune", number(), 87, no_number, no_number, 3, 40, "a, b"},
                  {"greedy", number(), 51, number(), number(), 5, 60, ""}};
  return design;
}

template <class A, class B>
void check_bits(const A& a, const B& b) {
  REQUIRE(a.size() == b.size());
  for (Eigen::Index i = 0; i < a.size(); ++i)
    CHECK(std::bit_cast<std::uint64_t>(a.data()[i]) == std::bit_cast<std::uint64_t>(b.data()[i]));
}

void check_end(const springs::End& a, const springs::End& b) {
  REQUIRE(a.index() == b.index());
  if (const auto* anchor = std::get_if<springs::AtAnchor>(&a)) {
    CHECK(anchor->anchor == std::get<springs::AtAnchor>(b).anchor);
    return;
  }
  CHECK(std::get<springs::OnRod>(a).rod == std::get<springs::OnRod>(b).rod);
  CHECK(std::get<springs::OnRod>(a).s == std::get<springs::OnRod>(b).s);
}

}  // namespace

TEST_CASE("a design is read back to the last bit") {
  const Folder folder;
  const Design design = sample();
  REQUIRE_FALSE(write_design(folder / "design.json", design));
  const auto read = read_design(folder / "design.json");
  if (!read) FAIL(read.error().text());
  CHECK(read->name == design.name);
  CHECK(read->status == design.status);
  CHECK(read->length_unit == "mm");
  CHECK(read->force_unit == "N");
  const Structure &found = read->structure, &written = design.structure;
  REQUIRE(found.rods.size() == 2);
  for (int i = 0; i < 2; ++i) {
    const der::Rod &a = found.rods[i], &b = written.rods[i];
    CHECK(a.closed == b.closed);
    CHECK(a.section.EA == b.section.EA);
    CHECK(a.section.EI1 == b.section.EI1);
    CHECK(a.section.EI2 == b.section.EI2);
    CHECK(a.section.GJ == b.section.GJ);
    check_bits(a.rest_lengths, b.rest_lengths);
    check_bits(read->target[i], design.target[i]);
    check_bits(read->pose[i], design.pose[i]);
    CHECK(a.closing_angle == b.closing_angle);
    check_bits(a.rest_curvature, b.rest_curvature);
    check_bits(a.rest_twist, b.rest_twist);
    check_bits(read->target_directors[i], design.target_directors[i]);
    check_bits(read->pose_directors[i], design.pose_directors[i]);
  }
  REQUIRE(found.point_loads.size() == 1);
  CHECK(found.point_loads[0].rod == 1);
  CHECK(found.point_loads[0].s == 0.0);
  CHECK(found.point_loads[0].force == written.point_loads[0].force);
  REQUIRE(found.line_loads.size() == 2);
  CHECK(found.line_loads[1].rod == 1);
  CHECK(found.line_loads[1].force_per_length == written.line_loads[1].force_per_length);
  check_bits(found.anchors, written.anchors);
  REQUIRE(found.pins.size() == 2);
  CHECK(found.pins[0].rod == 0);
  CHECK(found.pins[0].vertex == 3);
  CHECK(found.pins[0].axes == std::array{true, false, true});
  REQUIRE(found.cables.size() == 2);
  REQUIRE(read->built.size() == 2);
  for (int i = 0; i < 2; ++i) {
    const springs::Cable &a = found.cables[i], &b = written.cables[i];
    check_end(a.a, b.a);
    check_end(a.b, b.b);
    CHECK(read->built[i].length == design.built[i].length);
    CHECK(read->built[i].tension == design.built[i].tension);
    CHECK(a.stiffness == b.stiffness);
    CHECK(a.rest_length == b.rest_length);
  }
  CHECK(read->error->max_percent == design.error->max_percent);
  CHECK(read->error->rms_percent == design.error->rms_percent);
  CHECK(read->certificate->residual == design.certificate->residual);
  CHECK(read->certificate->smallest_eigenvalue == design.certificate->smallest_eigenvalue);
  CHECK(read->certificate->slack_cables == 1);
  CHECK_FALSE(read->certificate->stable);
  CHECK(read->certificate->off_by_errors == 0.25);
  CHECK(read->certificate->settles_from_target == false);
  CHECK(found.planar);
  REQUIRE(read->trace.size() == 2);
  CHECK(std::isnan(read->trace[0].max_percent));
  CHECK(read->trace[0].note == "a, b");
  CHECK(read->trace[1].rms_percent == design.trace[1].rms_percent);
  CHECK(read->trace[1].iterations == 60);

  // The same value gives the same bytes.
  REQUIRE_FALSE(write_design(folder / "again.json", *read));
  CHECK(folder.text("again.json") == folder.text("design.json"));
}

TEST_CASE("the file has the fields other programs rely on, in their order") {
  const Folder folder;
  Design design;
  design.structure.rods.push_back({.closed = false,
                                   .section = {.EA = 2, .EI1 = 1, .EI2 = 0.5, .GJ = 0.25},
                                   .rest_lengths = Eigen::VectorXd::Constant(1, 3.5)});
  design.target = design.pose = {Eigen::Matrix3Xd::Identity(3, 2)};
  design.target_directors = design.pose_directors = {Eigen::Matrix3Xd(3, 0)};
  design.structure.anchors = Eigen::Vector3d(1, 2, 3);
  design.structure.pins = {{0, 1, {false, false, true}}};
  design.structure.cables = {{.a = springs::OnRod{0, 0.5}, .b = springs::AtAnchor{0}}};
  design.built = {{.length = 2, .tension = 4}};
  design.error = DesignError{1, 0.5};
  design.certificate = Certificate{.residual = 1e-10, .smallest_eigenvalue = 0.125, .stable = true};
  design.trace = {{"slide", 0.5, 1, 1, 0.5, 2, 7, ""}};
  REQUIRE_FALSE(write_design(folder / "design.json", design));
  CHECK(folder.text("design.json") == R"({
 "schema": "tencer-design/2",
 "name": "",
 "status": "complete",
 "length_unit": "cm",
 "force_unit": "N",
 "rods": [
  {
   "closed": false,
   "EA": 2.0,
   "EI": [1.0,0.5],
   "GJ": 0.25,
   "rest_lengths": [3.5],
   "target": [
    [1.0,0.0,0.0],
    [0.0,1.0,0.0]
   ],
   "pose": [
    [1.0,0.0,0.0],
    [0.0,1.0,0.0]
   ]
  }
 ],
 "anchors": [
  [1.0,2.0,3.0]
 ],
 "pinned": [
  {"rod":0,"vertex":1,"axes":"z"}
 ],
 "planar": false,
 "cables": [
  {"a":{"rod":0,"s":0.5},"b":{"anchor":0},"length":2.0,"tension":4.0}
 ],
 "error": {"max_percent":1.0,"rms_percent":0.5},
 "certificate": {
  "residual": 1e-10,
  "smallest_eigenvalue": 0.125,
  "eigenvalue_unit": "max EI / L^4, one unit of mass per length",
  "slack_cables": 0,
  "stable": true
 },
 "trace": [
  {
   "stage": "slide",
   "seconds": 0.5,
   "cables": 1,
   "max_percent": 1.0,
   "rms_percent": 0.5,
   "equilibrium_solves": 2,
   "newton_iterations": 7,
   "note": ""
  }
 ]
}
)");
}

TEST_CASE("what rods are built of is read back, and strains at the pose") {
  const Folder folder;
  Design design = sample();
  Structure& structure = design.structure;
  structure.rods[0].section.shape = der::Tube{0.3, 0.1};
  structure.rods[1].section.shape = der::Rectangle{0.2, 0.7};
  structure.materials = {*find_material("ash"), glass_fibre()};
  structure.materials[1].density.reset();
  design.target[1] << 0, 1, 2, 0, 0, 0, 0, 0, 0;  // as other points may have a corner
  design.strains = {std::nullopt, BendingStrain{0.03, 0.125, 1, structure.rods[1].length() / 2}};
  REQUIRE_FALSE(write_design(folder / "design.json", design));
  const auto read = read_design(folder / "design.json");
  if (!read) FAIL(read.error().text());
  const auto& rods = read->structure.rods;
  CHECK(std::get<der::Tube>(rods[0].section.shape).inner_radius == 0.1);
  CHECK(std::get<der::Rectangle>(rods[1].section.shape).height == 0.7);
  REQUIRE(read->structure.materials.size() == 2);
  CHECK(read->structure.materials[0].name == "ash");
  CHECK(read->structure.materials[0].density == 680);
  CHECK_FALSE(read->structure.materials[1].density);
  REQUIRE(read->strains.size() == 2);
  CHECK_FALSE(read->strains[0]);
  CHECK(read->strains[1]->strain == 0.03);
  CHECK(read->strains[1]->vertex == 1);
  CHECK(read->strains[1]->s == design.strains[1]->s);
  CHECK(read->strains[1]->curvature == 0.125);
  // Beyond what glass fibre holds: why it is not complete stands in the file.
  CHECK_THAT(folder.text("design.json"),
             Catch::Contains("rod 1 is bent to a strain of 3 % at arc length"));
}

TEST_CASE("a design by another program needs the essentials only and may have keys of its own") {
  const Folder folder;
  const auto read = read_design(folder.put(
      "design.json", R"({"schema": "tencer-design/1", "length_unit": "m", "force_unit": "kN",
        "made_by": {"program": "x"}, "cables": [],
        "rods": [{"closed": false, "EA": 1, "EI": [1, 1], "GJ": 1, "colour": "red",
                  "rest_lengths": [1], "target": [[0,0,0],[1,0,0]], "pose": [[0,0,0],[1,0,0]]}]})"));
  if (!read) FAIL(read.error().text());
  CHECK(read->status == DesignStatus::complete);
  CHECK_FALSE(read->certificate);
  CHECK_FALSE(read->error);
  const Structure& structure = read->structure;
  CHECK_FALSE(structure.planar);
  CHECK(structure.anchors.cols() == 0);
  CHECK(structure.point_loads.empty());
  CHECK(structure.line_loads.empty());
  CHECK_FALSE(structure.rods[0].closing_angle);
  CHECK(structure.rods[0].rest_curvature.cols() == 0);
  CHECK(structure.rods[0].rest_twist.size() == 0);
  CHECK(read->target_directors[0].cols() == 0);
}

TEST_CASE("bad designs are refused by the writer, and the old file stays") {
  struct Case {
    std::function<void(Design&)> spoil;
    const char* error;
  };
  const Case cases[] = {
      {[](Design& d) { d.structure.rods.clear(); }, "rods: expected at least one rod"},
      {[](Design& d) { d.structure.rods[0].section.EA = 0; },
       "rods[0].EA: expected a positive number, found 0.0"},
      {[](Design& d) { d.structure.rods[1].section.EI2 = -2; },
       "rods[1].EI[1]: expected a positive number, found -2.0"},
      {[](Design& d) { d.structure.rods[1].section.GJ = no_number; },
       "rods[1].GJ: expected a finite number, found null"},
      {[](Design& d) { d.structure.rods[1].rest_lengths.conservativeResize(1); },
       "rods[1].rest_lengths: expected 2 numbers, found 1"},
      {[](Design& d) { d.structure.rods[0].rest_lengths[2] = 0; },
       "rods[0].rest_lengths[2]: expected a positive number, found 0.0"},
      {[](Design& d) { d.pose[0].conservativeResize(3, 3); },
       "rods[0].pose: expected 4 points, as in target, found 3"},
      {[](Design& d) { d.target[0].conservativeResize(3, 2); },
       "rods[0].target: expected at least 3 points, found 2"},
      {[](Design& d) { d.pose[0](1, 2) = 1 / 0.0; },
       "rods[0].pose[2][1]: expected a finite number, found null"},
      {[](Design& d) { d.pose[0].col(3) = d.pose[0].col(2); },
       "rods[0].pose[2]: zero-length edge: the next point is the same"},
      {[](Design& d) { d.target[1].col(2) = d.target[1].col(0); },
       "rods[1].target[1]: the rod turns straight back here, which none can follow"},
      {[](Design& d) { d.structure.rods[1].closing_angle = 1.0; },
       "rods[1].closing_angle: belongs to closed rods"},
      {[](Design& d) { d.structure.rods[0].rest_curvature = Eigen::Matrix2Xd::Zero(2, 3); },
       "rods[0].rest_curvature: expected 4 pairs, found 3"},
      {[](Design& d) { d.structure.rods[1].rest_twist = Eigen::VectorXd::Zero(2); },
       "rods[1].rest_twist: expected 1 numbers, found 2"},
      {[](Design& d) { d.target_directors[0].conservativeResize(3, 3); },
       "rods[0].target_directors: expected 4 directions, one an edge, found 3"},
      {[](Design& d) { d.pose_directors[1].col(1) = d.pose[1].col(1) - d.pose[1].col(2); },
       "rods[1].pose_directors[1]: expected a direction that is not along the edge"},
      {[](Design& d) { d.structure.point_loads[0].rod = 2; },
       "point_loads[0].rod: there is no rod 2; use 0 to 1"},
      {[](Design& d) { d.structure.point_loads[0].force[1] = no_number; },
       "point_loads[0].force[1]: expected a finite number, found null"},
      {[](Design& d) { d.structure.line_loads[1].rod = -1; },
       "line_loads[1].rod: expected a whole number from 0, found -1"},
      {[](Design& d) { d.structure.anchors(0, 1) = no_number; },
       "anchors[1][0]: expected a finite number, found null"},
      {[](Design& d) { d.structure.pins[1].vertex = 3; },
       "pinned[1].vertex: there is no vertex 3; use 0 to 2"},
      {[](Design& d) { d.structure.pins[0].rod = -1; },
       "pinned[0].rod: expected a whole number from 0, found -1"},
      {[](Design& d) {
         d.structure.pins[0].axes = {false, false, false};
       },
       "pinned[0].axes: expected letters of \"xyz\", found none"},
      {[](Design& d) {
         d.structure.cables[0].a = springs::OnRod{2, 0.0};
       },
       "cables[0].a.rod: there is no rod 2; use 0 to 1"},
      {[](Design& d) { d.structure.cables[1].b = springs::AtAnchor{2}; },
       "cables[1].b.anchor: there is no anchor 2; use 0 to 1"},
      {[](Design& d) { std::get<springs::OnRod>(d.structure.cables[0].b).s = -1e-9; },
       "cables[0].b.s: expected a number that is not negative, found -1e-09"},
      {[](Design& d) {
         d.structure.rods[1].rest_lengths << 1, 2;
         std::get<springs::OnRod>(d.structure.cables[0].b).s = 3.0001;
       },
       "cables[0].b.s: expected an arc length from 0 to 3, found 3.0001"},
      {[](Design& d) { d.structure.cables[1].a = springs::AtAnchor{0}; },
       "cables[1]: a cable from anchor to anchor holds no rod"},
      {[](Design& d) { d.built[0].length = 0; },
       "cables[0].length: expected a positive number, found 0.0"},
      {[](Design& d) { d.built[0].tension = no_number; },
       "cables[0].tension: expected a finite number, found null"},
      {[](Design& d) { d.structure.cables[1].stiffness = -1; },
       "cables[1].stiffness: expected a positive number, found -1.0"},
      {[](Design& d) { d.error->max_percent = no_number; },
       "error.max_percent: expected a finite number, found null"},
      {[](Design& d) { d.certificate->smallest_eigenvalue = no_number; },
       "certificate.smallest_eigenvalue: expected a finite number, found null"},
      {[](Design& d) { d.certificate->slack_cables = -1; },
       "certificate.slack_cables: expected a whole number from 0, found -1"},
      {[](Design& d) { d.trace[0].seconds = -1; },
       "trace[0].seconds: expected a number that is not negative, found -1.0"},
  };
  const Folder folder;
  folder.put("design.json", "old");
  for (const Case& bad : cases) {
    CAPTURE(bad.error);
    Design design = sample();
    bad.spoil(design);
    const auto error = write_design(folder / "design.json", design);
    REQUIRE(error);
    CHECK(folder.local(error->text()) == std::string("design.json: ") + bad.error);
  }
  CHECK(folder.text("design.json") == "old");
  CHECK(folder.files() == 1);
}

TEST_CASE("bad design files are refused with their key or line") {
  const Folder folder;
  const std::string rods =
      R"("rods": [{"closed": true, "EA": 1, "EI": 1, "GJ": 1, "rest_lengths": [], "target": [],
         "pose": []}])";
  const std::string head = R"("schema": "tencer-design/1", "length_unit": "cm", "force_unit": "N")";
  const auto with_cable = [&](const std::string& cable) {
    return "{" + head +
           R"(, "anchors": [[0, 0, 9]], "rods": [{"closed": false, "EA": 1, "EI": [1, 1], "GJ": 1,
           "rest_lengths": [1], "target": [[0, 0, 0], [1, 0, 0]], "pose": [[0, 0, 0], [1, 0, 0]]}],
           "cables": [{"a": {"rod": 0, "s": 0}, "length": 1, "tension": 1, )" +
           cable + "}]}";
  };
  struct Case {
    std::string text;
    const char* error;
  };
  const Case cases[] = {
      {"",
       "design.json:1: is not valid JSON: syntax error while parsing value - unexpected end of "
       "input; expected '[', '{', or a literal"},
      {"{\n\"schema\": \"tencer-design/1\",\n\"rods\": [}\n",
       "design.json:3: is not valid JSON: syntax error while parsing value - unexpected '}'; "
       "expected '[', '{', or a literal"},
      {"[]", "design.json: is not a design: expected an object"},
      {"{}", "design.json: the key \"schema\" is missing"},
      {R"({"schema": "tencer-design/3"})",
       "design.json: schema: expected \"tencer-design/2\" or \"tencer-design/1\", found "
       "\"tencer-design/3\""},
      {R"({"schema": 1})", "design.json: schema: expected a text, found 1"},
      {"{" + head + "}", "design.json: the key \"rods\" is missing"},
      {"{" + head + R"(, "status": "done"})",
       "design.json: status: expected \"complete\", \"tolerance-not-reached\" or \"interrupted\", "
       "found \"done\""},
      {"{" + head + "," + rods + "}", "design.json: rods[0].EI: expected an array, found 1"},
      {"{" + head + R"(, "rods": [3]})", "design.json: rods[0]: expected an object, found 3"},
      {with_cable(R"("b": {"rod": 0, "s": 1, "anchor": 0})"),
       "design.json: cables[0].b: expected {\"rod\", \"s\"} or {\"anchor\"}"},
      {with_cable(R"("b": {"anchor": 0}, "stiffness": 1)"),
       "design.json: cables[0]: stiffness and rest_length belong together: give both or neither"},
  };
  for (const Case& bad : cases) {
    CAPTURE(bad.text);
    const auto design = read_design(folder.put("design.json", bad.text));
    REQUIRE_FALSE(design);
    CHECK(folder.local(design.error().text()) == bad.error);
  }
  CHECK(folder.local(read_design(folder / "none.json").error().text()) ==
        "none.json: there is no such file");
}

TEST_CASE("no text makes the design reader throw, and what it reads can be written") {
  const Folder folder;
  REQUIRE_FALSE(write_design(folder / "design.json", sample()));
  const std::string text = folder.text("design.json");
  std::mt19937 random(19);
  int read = 0;
  for (int trial = 0; trial < 1000; ++trial) {
    const auto design = read_design(folder.put("design.json", edited(text, trial % 4, random)));
    if (design) {
      ++read;
      REQUIRE_FALSE(write_design(folder / "again.json", *design));
    } else {
      REQUIRE(design.error().where.starts_with(folder.path().string()));
    }
  }
  CHECK(read >= 250);
}

TEST_CASE("a name that is not UTF-8 does not lose the design") {
  const Folder folder;
  Design design = sample();
  design.name = "caf\xe9";
  REQUIRE_FALSE(write_design(folder / "design.json", design));
  CHECK(read_design(folder / "design.json").value().name == "caf\xEF\xBF\xBD");
}
