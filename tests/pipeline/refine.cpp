// Finer simulations of the same design.
#include <tencer/model/subdivision.hpp>
#include <tencer/pipeline/simulate.hpp>

#include "scenes.hpp"

using namespace tencer;

namespace {

// A ring of circumference 2 pi whose diameter is shortened by a cable, at rest.
model::Design ring(int vertices) {
  model::Design design;
  const geometry::Polyline circle = curves::circle(1.0, vertices);
  design.structure.rods = {{.closed = true,
                            .section = {.EA = 1e6, .EI1 = 1, .EI2 = 1, .GJ = 0.8},
                            .rest_lengths = geometry::edge_lengths(circle)}};
  design.target = design.pose = {circle.points};
  design.target_directors = design.pose_directors = {Eigen::Matrix3Xd(3, 0)};
  const double length = design.structure.rods[0].length();
  design.structure.cables = {
      {.a = springs::OnRod{0, 0.1 * length}, .b = springs::OnRod{0, 0.6 * length}}};
  design.built = {{.length = 1.5}};
  const auto simulation = pipeline::simulate(design);
  REQUIRE(simulation);
  REQUIRE(simulation->usable());
  return simulation->design;
}

double moved(const model::Design& design, int times) {
  const auto simulation = pipeline::simulate(design, {.refine = times});
  REQUIRE(simulation);
  REQUIRE(simulation->usable());
  CHECK(simulation->design.pose[0].cols() == times * design.pose[0].cols());
  CHECK(simulation->design.certificate->stable);
  return simulation->moved_percent;
}

}  // namespace

TEST_CASE("a design moves by the square of the edge length when its rods are refined") {
  const double coarse = moved(ring(20), 4);
  const double fine = moved(ring(40), 4);
  const double finer = moved(ring(80), 4);
  CAPTURE(coarse, fine, finer);
  CHECK(finer < 0.1);
  CHECK(std::log2(coarse / fine) == Approx(2).margin(0.25));
  CHECK(std::log2(fine / finer) == Approx(2).margin(0.1));
  CHECK(moved(ring(40), 1) < 1e-6);
}

TEST_CASE("refining once is the same design") {
  const model::Design design = ring(20);
  CHECK(io::design_text(model::subdivided(design, 1)) == io::design_text(design));
}
