// Designs of which only what is seen from a side has to be right.
#include <Eigen/Geometry>
#include <numbers>
#include <tencer/pipeline/feasible.hpp>
#include <tencer/pipeline/simulate.hpp>

#include "scenes.hpp"

using namespace tencer;

namespace {

// A trefoil, pulled out along z.
model::Scene seen_trefoil() {
  model::Scene scene = trefoil_scene(36);
  Eigen::Matrix3Xd points = scene.target.points[0];
  points.row(2) *= 1.5;
  retarget(scene, 0, points);
  scene.target.views = {{.direction = {0, 0, 1}}};
  scene.design.effort = 1;
  return scene;
}

const model::Design& seen_design() {
  static const model::Design design = designed(seen_trefoil());
  return design;
}

Eigen::Matrix3d turn() {
  return Eigen::AngleAxisd(1.1, Eigen::Vector3d(1, 2, -0.5).normalized()).toRotationMatrix();
}

}  // namespace

TEST_CASE("the error of a design is what is seen of it, also in its file and let go again") {
  const model::Design& design = seen_design();
  REQUIRE(design.views.size() == 1);
  REQUIRE(design.error);
  Eigen::Matrix3Xd away = design.pose[0] - design.target[0];
  const double depth = away.row(2).cwiseAbs().maxCoeff();
  away.row(2).setZero();
  const double percent = 100 / model::diagonal({.points = design.target});
  CHECK(design.error->max_percent ==
        Approx(percent * away.colwise().norm().maxCoeff()).epsilon(1e-6));
  CHECK(design.error->max_percent <= model::DesignSettings{}.max_error);
  CHECK(percent * depth > design.error->max_percent);
  CHECK_FALSE(design.at_least);
  CHECK_THAT(model::summary(design), Catch::Matchers::Contains("seen along (0, 0, 1)"));
  const auto again = pipeline::simulate(design);
  REQUIRE(again);
  CHECK(again->stays());
  CHECK(again->design.error->max_percent == Approx(design.error->max_percent).epsilon(1e-3));
}

TEST_CASE("a design turned with its view is as far from its target") {
  const model::Design& design = seen_design();
  model::Design other = design;
  other.target[0] = turn() * design.target[0];
  other.pose[0] = turn() * design.pose[0];
  other.views = model::turned(design.views, turn());
  other.target_directors[0].resize(3, 0);
  other.pose_directors[0].resize(3, 0);
  const auto rest = pipeline::simulate(other);
  REQUIRE(rest);
  CHECK(rest->stays());
  const auto length = [](const model::Design& of) {
    return of.error->max_percent * model::diagonal({.points = of.target});
  };
  CHECK(length(rest->design) == Approx(length(design)).epsilon(1e-4));
  // From elsewhere it is not what was asked for.
  other.views = design.views;
  const auto elsewhere = pipeline::simulate(other);
  REQUIRE(elsewhere);
  CHECK(length(elsewhere->design) > 1.05 * length(design));
}

TEST_CASE("what cannot be held in space may look the same elsewhere") {
  // The letter S, of two arcs.
  constexpr int half = 40;
  geometry::Polyline arcs{.points = Eigen::Matrix3Xd(3, 2 * half - 1), .closed = false};
  for (int i = 0; i < half; ++i) {
    const double angle = std::numbers::pi * (0.1 + 1.4 * i / (half - 1));
    arcs.points.col(i) << 10 * std::cos(angle), 10 + 10 * std::sin(angle), 0;
    arcs.points.col(2 * half - 2 - i) << -10 * std::cos(angle), -10 - 10 * std::sin(angle), 0;
  }
  model::Scene scene = model::scene_of({arcs}, "S");
  REQUIRE(pipeline::feasible(scene)->verdict == model::Verdict::cannot);
  scene.target.views = {{.direction = {0, 0, 1}}};
  const auto found = pipeline::feasible(scene);
  REQUIRE(found);
  CHECK(found->verdict == model::Verdict::unclear);
  CHECK(found->at_least.cables == 0);
}

TEST_CASE("a symmetry that does not keep the view is none of the scene") {
  model::Scene scene = trefoil_scene(60);
  scene.design.symmetry = model::SymmetryUse::detect;
  const auto order = [&] {
    const auto problem = prepared_of(scene).problem;
    return problem.symmetry ? problem.symmetry->order() : 1;
  };
  const int all = order();
  REQUIRE(all == 6);
  scene.target.views = {{.direction = {0, 0, 1}}};
  CHECK(order() == all);
  scene.target.views = {{.direction = {1, 0.3, 1}}};
  CHECK(order() == 1);
}
