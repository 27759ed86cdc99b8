#include <catch2/catch.hpp>
#include <tencer/model/scaling.hpp>

#include "fixtures/rods.hpp"

using namespace tencer;
using namespace tencer::fixtures;

namespace {

// The model 37 times as large, elsewhere, and 5 times as stiff.
Model in_other_units() {
  Model model = hung_helix(25);
  auto& rod = model.structure.rods[0];
  rod.rest_lengths *= 37;
  rod.section.EA *= 5;
  for (double* stiffness : {&rod.section.EI1, &rod.section.EI2, &rod.section.GJ})
    *stiffness *= 5 * 37 * 37;
  const Eigen::Vector3d shift(100, -30, 7);
  model.positions[0] = (37 * model.positions[0]).colwise() + shift;
  model.structure.anchors = (37 * model.structure.anchors).colwise() + shift;
  return model;
}

}  // namespace

TEST_CASE("scaled, the rods' length and their bending stiffness over it are 1") {
  const Model model = in_other_units();
  const auto scaling = model::scaling_of(model.structure, model.positions);
  const model::Structure structure = model::scaled(model.structure, scaling);
  CHECK(total_length(structure) == Approx(1).epsilon(1e-14));
  CHECK(structure.rods[0].section.EI1 == Approx(1).epsilon(1e-14));
  CHECK(structure.rods[0].section.EA == Approx(1.6e7).epsilon(1e-14));
  const auto points = model::scaled(model.positions, scaling);
  CHECK(points[0].rowwise().mean().norm() < 1e-14);
  CHECK((scaling.unscaled(points[0]) - model.positions[0]).norm() < 1e-11);
}

TEST_CASE("a cable comes back from scaled units") {
  Model model = in_other_units();
  const double length = model.structure.rods[0].length();
  model.structure.cables = {{.a = springs::OnRod{0, 0.3 * length},
                             .b = springs::AtAnchor{2},
                             .stiffness = 12,
                             .rest_length = 3}};
  const auto scaling = model::scaling_of(model.structure, model.positions);
  const model::Structure structure = model::scaled(model.structure, scaling);
  const springs::Cable cable = model::unscaled(structure.cables[0], structure, scaling);
  CHECK(std::get<springs::OnRod>(cable.a).s == Approx(0.3 * length).epsilon(1e-14));
  CHECK(std::get<springs::AtAnchor>(cable.b).anchor == 2);
  CHECK(cable.stiffness == Approx(12).epsilon(1e-14));
  CHECK(cable.rest_length == Approx(3).epsilon(1e-14));
}

TEST_CASE("forbidden vertices and the ends of forbidden arcs are forbidden in scaled units too") {
  const Model model = in_other_units();
  const Eigen::VectorXd knots = arc_lengths(model.structure)[0].knots();
  model::Rules rules{.forbidden = {{0, knots[2], knots[5]}}};
  for (int i = 8; i < 25; ++i) rules.forbidden.push_back({0, knots[i], knots[i]});
  const auto scaling = model::scaling_of(model.structure, model.positions);
  const model::Structure structure = model::scaled(model.structure, scaling);
  const model::Rules scaled = model::scaled(rules, scaling);
  const Eigen::VectorXd vertices = arc_lengths(structure)[0].knots();
  for (int i = 0; i < 25; ++i) {
    CAPTURE(i);
    const bool allowed = i < 2 || (i > 5 && i < 8);
    CHECK(place_allowed(rules, model.structure, 0, knots[i]) == allowed);
    CHECK(place_allowed(scaled, structure, 0, vertices[i]) == allowed);
  }
}
