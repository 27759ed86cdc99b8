#include <catch2/catch.hpp>
#include <cmath>
#include <tencer/model/target.hpp>

#include "fixtures/rods.hpp"

using namespace tencer;
using namespace tencer::fixtures;
using model::make_target;

TEST_CASE("anchors and pins keep a target from being aligned") {
  Model ring = trefoil(20);
  CHECK(make_target(ring.structure, ring.positions).align);
  ring.structure.pins = {{.rod = 0, .vertex = 2}};
  CHECK_FALSE(make_target(ring.structure, ring.positions).align);
  Model helix = hung_helix(12);
  CHECK(make_target(helix.structure, helix.positions).align);
  helix.structure.cables = {{.a = springs::AtAnchor{3}, .b = springs::OnRod{0, 0.5}}};
  CHECK_FALSE(make_target(helix.structure, helix.positions).align);
}

TEST_CASE("targets that do not fit are refused") {
  const Model model = linked_ellipses(16);
  const model::Target fitting = make_target(model.structure, model.positions);
  const auto refused = [&](const auto& change) {
    model::Target target = fitting;
    change(target);
    CHECK_THROWS_AS(validate(target, model.structure), std::invalid_argument);
  };
  CHECK_NOTHROW(validate(fitting, model.structure));
  refused([](model::Target& t) { t.points.pop_back(); });
  refused([](model::Target& t) { t.points[1].conservativeResize(3, 5); });
  refused([](model::Target& t) { t.points[1](0, 0) = std::nan(""); });
  refused([](model::Target& t) { t.weights = {Eigen::VectorXd::Ones(16)}; });
  refused([](model::Target& t) {
    t.weights = {Eigen::VectorXd::Ones(16), -Eigen::VectorXd::Ones(16)};
  });
  refused([](model::Target& t) {
    t.weights = {Eigen::VectorXd::Zero(16), Eigen::VectorXd::Zero(16)};
  });
}
