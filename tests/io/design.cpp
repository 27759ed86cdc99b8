#include <bit>
#include <catch2/catch.hpp>
#include <cstdint>
#include <tencer/io/design.hpp>

#include "fixtures/folder.hpp"
#include "sample_design.hpp"

using namespace tencer;
using namespace tencer::io;
using namespace tencer::model;

namespace {

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
  REQUIRE(read->at_least);
  CHECK(read->at_least->cables == 1);
  CHECK(read->at_least->ends == 2);
  CHECK(read->at_least->error_percent == 0.5);
  REQUIRE(read->at_least->stretches.size() == 1);
  CHECK(read->at_least->stretches[0].rod == 1);
  CHECK(read->at_least->stretches[0].to == 0.75);
  CHECK(found.planar);
  REQUIRE(read->trace.size() == 2);
  CHECK(std::isnan(read->trace[0].max_percent));
  CHECK(read->trace[0].note == "a, b");
  CHECK(read->trace[1].rms_percent == design.trace[1].rms_percent);
  CHECK(read->trace[1].iterations == 60);
  CHECK(read->trace[0].snapshots.empty());
  REQUIRE(read->trace[1].snapshots.size() == 1);
  const Snapshot &seen = read->trace[1].snapshots[0], &shown = design.trace[1].snapshots[0];
  CHECK(seen.max_percent == shown.max_percent);
  REQUIRE(seen.rods.size() == 1);
  CHECK(seen.rods[0].isApprox(shown.rods[0], 1e-3));
  CHECK(seen.cable_ends.isApprox(shown.cable_ends, 1e-3));
  CHECK(seen.tensions.isApprox(shown.tensions, 1e-3));

  // The same value gives the same bytes.
  REQUIRE_FALSE(write_design(folder / "again.json", *read));
  CHECK(folder.text("again.json") == folder.text("design.json"));
}

TEST_CASE("a design's views are read back, and are not those of a planar one") {
  const Folder folder;
  Design design = sample();
  design.structure.planar = false;
  design.views = {{.direction = {0, 0.25, 1}}, {.direction = {1, 0, 0}, .weight = 2.5}};
  REQUIRE_FALSE(write_design(folder / "design.json", design));
  const auto read = read_design(folder / "design.json");
  if (!read) FAIL(read.error().text());
  REQUIRE(read->views.size() == 2);
  for (int i = 0; i < 2; ++i) {
    CHECK(read->views[i].direction == design.views[i].direction);
    CHECK(read->views[i].weight == design.views[i].weight);
  }
  std::string text = folder.text("design.json");
  const std::string in_space = "\"planar\": false";
  REQUIRE(text.find(in_space) != std::string::npos);
  text.replace(text.find(in_space), in_space.size(), "\"planar\": true");
  const auto refused = read_design(folder.put("planar.json", text));
  REQUIRE_FALSE(refused);
  CHECK_THAT(refused.error().text(), Catch::Matchers::Contains("views: a planar design"));
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
             Catch::Contains("rod B is bent to a strain of 3 % at arc length"));
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

TEST_CASE("a name that is not UTF-8 does not lose the design") {
  const Folder folder;
  Design design = sample();
  design.name = "caf\xe9";
  REQUIRE_FALSE(write_design(folder / "design.json", design));
  CHECK(read_design(folder / "design.json").value().name == "caf\xEF\xBF\xBD");
}
