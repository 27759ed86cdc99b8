// Designs that the writer refuses, and files that the reader does.
#include <catch2/catch.hpp>
#include <functional>
#include <random>
#include <tencer/io/design.hpp>

#include "edited.hpp"
#include "fixtures/folder.hpp"
#include "sample_design.hpp"

using namespace tencer;
using namespace tencer::io;
using namespace tencer::model;

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
