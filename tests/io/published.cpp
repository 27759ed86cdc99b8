#include <catch2/catch.hpp>
#include <numbers>
#include <string>
#include <tencer/io/curve.hpp>
#include <tencer/io/design.hpp>
#include <tencer/io/scene.hpp>

#include "fixtures/folder.hpp"

using namespace tencer;

namespace {

// A square of 2 x 2 pulled in at two corners, and a straight rod of two edges.
const std::string target = "[[0,0,0],[2,0,0],[2,2,0],[0,2,0]]";
const std::string pose = "[[0.1,0.1,0],[2,0,0],[1.9,1.9,0],[0,2,0]]";

std::string published(const std::string& cables, const std::string& anchors = "[]") {
  return R"({"name": "square", "rods": [{"closed": true, "youngs_modulus": 1e6, "radius": 0.1,)"
         R"("rest_lengths": [2,2,2,2], "target": )" +
         target + R"(, "published_equilibrium": )" + pose + "}], \"anchors\": " + anchors +
         ", \"cables\": " + cables + "}";
}

// The same as the paper's program saves it, with a frame: an open rod through (-1,0,0), (-1,-1,0)
// and (0,-1,0). Its closed rods have their first edge twice.
std::string program_state(const std::string& type, const std::string& variables,
                          const std::string& more) {
  const std::string frame = "-1,0,0, -1,-1,0, 0,-1,0";
  const std::string angles4 = ",0,0,0,0";
  return R"({"numOpenRods": 1, "numClosedRods": 1, "numSprings": 2, "YoungModulus": [1e6, 1e6],)"
         R"("crossSection": [0.1, 0.1], "rodRestLengths": [[1, 1], [2, 2, 2, 2, 2]],)"
         R"("targetDefoVars": [[)" +
         frame + R"(,0,0], [0,0,0, 2,0,0, 2,2,0, 0,2,0, 0,0,0, 2,0,0)" + angles4 +
         R"(,0]], "defoVars": [)" + frame + ",0,0, 0.1,0.1,0, 2,0,0, 1.9,1.9,0, 0,2,0" + angles4 +
         R"(,7], "restVarType": )" + type + ", \"restVars\": " + variables +
         ", \"springRestLengths\": [1, 0]" + more + "}";
}

const std::string on_vertices = ", \"attachmentVertices\": [[1, 0, 1, 2], [1, 4, 0, 1]]";
const std::string along = ", \"attachmentVertices\": [], \"spring_rod_anchor\": [[1, 1], [1, 0]]";

void check_cables(const model::Design& design) {
  const auto& cables = design.structure.cables;
  REQUIRE(cables.size() == 2);
  CHECK(std::get<springs::OnRod>(cables[0].a).s == 0);
  CHECK(std::get<springs::OnRod>(cables[0].b).s == 4);
  CHECK(cables[0].stiffness == 3);
  CHECK(cables[0].rest_length == 1);
  CHECK(design.built[0].length == Approx(1.8 * std::numbers::sqrt2));
  CHECK(design.built[0].tension == Approx(3 * (1.8 * std::numbers::sqrt2 - 1)));
  CHECK(std::get<springs::OnRod>(cables[1].a).s == 0);
  CHECK(design.built[1].length == Approx(1.1 * std::numbers::sqrt2));
}

}  // namespace

TEST_CASE("a published model is read as a design in cm and N") {
  const Folder folder;
  const auto path = folder.put(
      "m.json",
      published(
          R"([{"a": {"rod": 0, "s": 0}, "b": {"rod": 0, "s": 4}, "stiffness": 3, "rest_length": 1},)"
          R"({"a": {"rod": 0, "s": 0}, "b": {"anchor": 0}, "stiffness": 2, "rest_length": 0}])",
          "[[-1,-1,0]]"));
  const auto design = io::read_design(path);
  if (!design) FAIL(design.error().text());
  CHECK(design->name == "square");
  CHECK(design->length_unit == "cm");
  CHECK(design->force_unit == "N");
  CHECK(design->structure.planar);
  const der::Rod& rod = design->structure.rods.at(0);
  CHECK(rod.closed);
  CHECK(rod.section.EA == Approx(1e6 * std::numbers::pi * 0.01).epsilon(1e-5));
  CHECK(std::get<der::Circle>(rod.section.shape).radius == 0.1);
  CHECK(design->pose[0].col(0) == Eigen::Vector3d(0.1, 0.1, 0));
  check_cables(*design);
  // What was read can be written.
  CHECK_FALSE(io::write_design(folder / "design.json", *design));
  CHECK(io::read_design(folder / "design.json"));

  const auto scene = io::read_any_scene(path);
  REQUIRE(scene);
  CHECK(scene->target.points[0] == design->target[0]);
  CHECK(scene->structure.rods[0].section.EA == rod.section.EA);
  CHECK(scene->structure.anchors.cols() == 1);
  CHECK(scene->structure.cables.empty());
  CHECK(io::read_curves(path).value().at(0).closed);
  CHECK(io::read_any_scene(path, {.close = true}).error().text() ==
        path.string() +
            ": says itself which curves are closed and in which units it is; --closed is for bare "
            "curves: leave it out");
}

TEST_CASE("what the paper's program saves is the same design, its frame being anchors") {
  const Folder folder;
  for (const auto& text : {program_state("0", "[3, 2]", on_vertices),
                           program_state("3", "[3, 2, 0, 4, 8, 1]", along)}) {
    const auto design = io::read_design(folder.put("state.json", text));
    if (!design) FAIL(design.error().text());
    CHECK(design->name == "state");
    REQUIRE(design->structure.rods.size() == 1);
    CHECK(design->structure.rods[0].rest_lengths == Eigen::Vector4d::Constant(2));
    CHECK(design->structure.anchors.cols() == 3);
    CHECK(std::get<springs::AtAnchor>(design->structure.cables[1].b).anchor == 1);
    CHECK(design->pose[0].col(2) == Eigen::Vector3d(1.9, 1.9, 0));
    CHECK(design->target[0].col(2) == Eigen::Vector3d(2, 2, 0));
    check_cables(*design);
  }
}

TEST_CASE("designs of the paper that are bad are refused with the key") {
  const Folder folder;
  const auto error = [&](const std::string& text) {
    const auto design = io::read_design(folder.put("m.json", text));
    return design ? "none" : folder.local(design.error().text());
  };
  CHECK(error(published(R"([{"a": {"rod": 1, "s": 0}, "b": {"rod": 0, "s": 4}}])")) ==
        "m.json: cables[0].a.rod: there is no rod 1; use 0");
  CHECK(error(published(R"([{"a": {"rod": 0, "s": 0}, "b": {"rod": 0, "s": 8},)"
                        R"("stiffness": 3, "rest_length": 1}])")) ==
        "m.json: cables: the two ends of cable 0 are the same point");
  CHECK(error(program_state("2", "[3, 2]", on_vertices)) ==
        "m.json: restVarType: expected 0 or 3, found 2, with which the file holds only a part of "
        "stiffnesses and places of the springs");
  CHECK(error(program_state("0", "[3]", on_vertices)) ==
        "m.json: restVars: expected 2 entries, one a variable, found 1");
  CHECK(error(program_state("0", "[3, 2]",
                            ", \"attachmentVertices\": [[1, 0, 1, 2], [1, 6, 0, 1]]")) ==
        "m.json: attachmentVertices[1][1]: there is no such vertex of 6");
  CHECK(error(program_state("3", "[3, 2, 0, 4, 8, 1]", "")) ==
        "m.json: the key \"spring_rod_anchor\" is missing: which rods the springs are tied to");
}
