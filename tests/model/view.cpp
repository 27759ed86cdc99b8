#include <Eigen/Geometry>
#include <catch2/catch.hpp>
#include <cmath>
#include <tencer/model/target.hpp>

#include "fixtures/rods.hpp"

using namespace tencer;
using model::View;

TEST_CASE("what is seen of a distance is what lies across the view") {
  const View along{.direction = {0, 0, 5}};
  CHECK(model::seen_metric({}).isIdentity(0));
  CHECK(
      model::seen_metric({along}).isApprox(Eigen::Vector3d(1, 1, 0).asDiagonal().toDenseMatrix()));
  // Three to one: of a distance along x a quarter of the square is seen.
  const std::vector<View> two{{.direction = {1, 0, 0}, .weight = 3}, along};
  CHECK(model::seen_metric(two).isApprox(
      Eigen::Vector3d(0.25, 1, 0.75).asDiagonal().toDenseMatrix()));
  const Eigen::Matrix3d turn =
      Eigen::AngleAxisd(1, Eigen::Vector3d(1, 2, 3).normalized()).toRotationMatrix();
  const auto turned = model::turned(two, turn);
  CHECK(model::seen_metric(turned).isApprox(turn * model::seen_metric(two) * turn.transpose()));
  for (const auto& views : {two, turned, {along}}) {
    const Eigen::Matrix3d root = model::seeing(views);
    CHECK((root * root).isApprox(model::seen_metric(views)));
    CHECK(root.isApprox(root.transpose()));
  }
  CHECK((model::seeing({along}) * Eigen::Vector3d(0, 0, 7)).norm() == 0);
}

TEST_CASE("views that see nothing are refused") {
  CHECK_FALSE(model::view_problem({}));
  CHECK_FALSE(model::view_problem({{.direction = {1e-9, 0, 0}, .weight = 1e3}}));
  CHECK(model::view_problem({{.direction = {0, 0, 0}}}));
  CHECK(model::view_problem({{.direction = {0, NAN, 1}}}));
  CHECK(model::view_problem({{}, {.weight = 0}}) == "views[1]: expected a weight above 0");
  CHECK(model::seen_in_words({{.direction = {0, 0, 1}}, {.direction = {1, 0.5, 0}}}) ==
        "seen along (0, 0, 1) and (1, 0.5, 0)");

  const fixtures::Model ring = fixtures::trefoil(20);
  auto target = model::make_target(ring.structure, ring.positions);
  target.views = {{.direction = {0, 0, 1}}};
  CHECK_NOTHROW(validate(target, ring.structure));
  target.planar = true;
  CHECK_THROWS_AS(validate(target, ring.structure), std::invalid_argument);
}
