// A design that goes on from another, and one whose time is short.
#include "scenes.hpp"

using namespace tencer;
using Catch::Matchers::Contains;

namespace {

const model::Design& first() {
  static const model::Design design = [] {
    model::Scene scene = trefoil_scene();
    scene.design.cables = 8;
    scene.design.effort = 1;
    return designed(scene);
  }();
  return design;
}

model::Scene edited(const model::Edit& edit) {
  model::Scene scene = trefoil_scene();
  scene.edit = edit;
  return scene;
}

std::vector<double> places(const model::Design& design, std::size_t cable) {
  const springs::Cable& found = design.structure.cables[cable];
  return {std::get<springs::OnRod>(found.a).s, std::get<springs::OnRod>(found.b).s};
}

}  // namespace

TEST_CASE("a design with a cable less, or one more, is as close as it can be with as many") {
  const std::size_t count = first().built.size();
  REQUIRE(count > 4);
  const model::Design fewer = designed(edited({.from = first(), .remove = 1}));
  CHECK(fewer.built.size() == count - 1);
  CHECK(fewer.certificate->stable);
  const model::Design more = designed(edited({.from = first(), .add = 1}));
  CHECK(more.built.size() <= count + 1);
  CHECK(more.certificate->stable);
  CHECK(more.error->max_percent <= 1.05 * first().error->max_percent);
  check_consistent(more);
}

TEST_CASE("cables that are kept stay as they are, and forbidden ones do not come back") {
  const model::Design next =
      designed(edited({.from = first(), .keep = {2, 5}, .forbid = {3}, .add = 1}));
  CHECK(next.built.size() <= first().built.size());
  CHECK(next.certificate->stable);
  for (const auto& [now, before] : {std::pair(0, 1), std::pair(1, 4)}) {
    const auto here = places(next, static_cast<std::size_t>(now));
    const auto there = places(first(), static_cast<std::size_t>(before));
    for (std::size_t end = 0; end < 2; ++end) CHECK(here[end] == Approx(there[end]).margin(1e-6));
    // As good as inextensible: to a thousandth or so.
    CHECK(next.built[static_cast<std::size_t>(now)].length ==
          Approx(first().built[static_cast<std::size_t>(before)].length).epsilon(3e-3));
  }
  model::Rules rules{.unwanted = {first().structure.cables[2]}};
  const auto along = model::arc_lengths(next.structure);
  for (const springs::Cable& cable : next.structure.cables)
    CHECK_FALSE(model::is_unwanted(rules, along, cable));
}

TEST_CASE("a target that has moved is met again, with other vertices too") {
  model::Scene scene = trefoil_scene(60);
  Eigen::Matrix3Xd points = scene.target.points[0];
  points.row(2) *= 1.1;
  retarget(scene, 0, points);
  scene.edit = model::Edit{.from = first()};
  const model::Design design = designed(scene);
  CHECK(design.certificate->stable);
  CHECK(design.error->max_percent <= 1.0);
  CHECK(design.pose[0].cols() == 60);
}

TEST_CASE("edits that cannot be made say why") {
  const auto complaint = [](const model::Edit& edit) { return error_of(edited(edit)); };
  CHECK_THAT(complaint({.from = first(), .keep = {99}}),
             Contains("edit.keep: there is no cable 99; the design has cables 1 to "));
  CHECK_THAT(complaint({.from = first(), .keep = {1}, .forbid = {1}}),
             Contains("edit.forbid: cable 1 is also to be kept"));
  CHECK_THAT(complaint({.from = first(), .remove = 50}), Contains("can go"));
  CHECK_THAT(complaint({.from = first(), .add = 1, .remove = 1}), Contains("either add or remove"));
  model::Design other = first();
  other.length_unit = "mm";
  CHECK_THAT(complaint({.from = other}), Contains("its units are mm and N, the scene's cm and N"));
  model::Scene two = scene_of({curves::circle(40, 30), curves::circle(20, 30)});
  two.edit = model::Edit{.from = first()};
  CHECK_THAT(error_of(two), Contains("edit.from: its rods, 1 closed and 0 open, are not"));
  const auto all = pipeline::trade_off(edited({.from = first(), .add = 1}));
  REQUIRE_FALSE(all);
  CHECK_THAT(all.error().text(), Contains("a trade-off for all"));
  model::Scene symmetric = edited({.from = first()});
  symmetric.design.symmetry = model::SymmetryUse::detect;
  CHECK_THAT(error_of(symmetric), Contains("symmetries are not kept"));
}

TEST_CASE("a search whose time is up ends with a design like any other") {
  model::Scene scene = trefoil_scene(100);
  scene.design.time = 0.05;
  const model::Design design = designed(scene);
  CHECK(design.status != model::DesignStatus::interrupted);
  CHECK_FALSE(design.structure.cables.empty());
  CHECK(design.certificate->stable);
  CHECK(design.certificate->residual < 1e-6);
  CHECK(design.trace.back().stage == "settle");
  check_consistent(design);
}
