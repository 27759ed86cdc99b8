// Finer simulations of the same design.
#include <tencer/pipeline/refine.hpp>
#include <tencer/pipeline/simulate.hpp>

#include "scenes.hpp"

using namespace tencer;

namespace {

// A ring of circumference 2 pi whose diameter is shortened by a cable, at rest.
io::Design ring(int vertices) {
  io::Design design;
  io::DesignRod rod;
  rod.closed = true;
  rod.EA = 1e6;
  rod.EI = {1, 1};
  rod.GJ = 0.8;
  rod.target = curves::circle(1.0, vertices).points;
  rod.pose = rod.target;
  rod.rest_lengths = geometry::edge_lengths({rod.target, true});
  const double length = rod.length();
  design.rods = {rod};
  design.cables = {
      {.a = {.rod = 0, .s = 0.1 * length}, .b = {.rod = 0, .s = 0.6 * length}, .length = 1.5}};
  const auto simulation = pipeline::simulate(design);
  REQUIRE(simulation);
  REQUIRE(simulation->usable());
  return simulation->design;
}

double moved(const io::Design& design, int times) {
  const auto simulation = pipeline::simulate(design, {.refine = times});
  REQUIRE(simulation);
  REQUIRE(simulation->usable());
  CHECK(simulation->design.rods[0].pose.cols() == times * design.rods[0].pose.cols());
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

TEST_CASE("refining keeps lengths, vertices, bends at rest and supports") {
  io::Design design;
  io::DesignRod open;
  open.rest_lengths = Eigen::Vector4d(1, 2, 1, 3);
  open.target = Eigen::Matrix3Xd::Random(3, 5);
  open.pose = Eigen::Matrix3Xd::Random(3, 5);
  open.rest_curvature = Eigen::Matrix2Xd::Constant(2, 3, 0.1);
  open.rest_curvature.array().rowwise() *= Eigen::RowVector3d(1.5, 1.5, 2).array();
  open.pose_directors = Eigen::Matrix3Xd::Random(3, 4);
  design.rods = {open};
  design.pinned = {{.rod = 0, .vertex = 0, .axes = {true, true, true}},
                   {.rod = 0, .vertex = 1, .axes = {true, false, true}},
                   {.rod = 0, .vertex = 4, .axes = {false, true, false}}};
  design.point_loads = {{.rod = 0, .s = 2.5, .force = {1, 2, 3}}};
  const io::Design fine = pipeline::refined(design, 3);
  const io::DesignRod& rod = fine.rods[0];
  CHECK(rod.length() == Approx(7));
  CHECK(rod.rest_lengths[4] == Approx(2.0 / 3));
  REQUIRE(rod.pose.cols() == 13);
  for (int i = 0; i < 5; ++i) {
    CHECK(rod.pose.col(3 * i) == open.pose.col(i));
    CHECK(rod.target.col(3 * i) == open.target.col(i));
  }
  // 0.1 per length everywhere.
  REQUIRE(rod.rest_curvature.cols() == 11);
  CHECK(rod.rest_curvature(0, 0) == Approx(0.1 / 3));
  CHECK(rod.rest_curvature(1, 2) == Approx(0.1 * (1.0 / 3 + 2.0 / 3) / 2));
  CHECK(rod.pose_directors.col(5) == open.pose_directors.col(1));
  CHECK(fine.point_loads[0].s == 2.5);

  // x and z are held along the first edge, and straight there.
  REQUIRE(fine.pinned.size() == 5);
  CHECK(fine.pinned[1].vertex == 3);
  CHECK(fine.pinned[2].vertex == 12);
  for (int k = 1; k < 3; ++k) {
    CHECK(fine.pinned[2 + k].vertex == k);
    CHECK(fine.pinned[2 + k].axes == std::array{true, false, true});
    const Eigen::Vector3d on_line =
        open.pose.col(0) + k / 3.0 * (open.pose.col(1) - open.pose.col(0));
    CHECK(rod.pose(0, k) == Approx(on_line.x()));
    CHECK(rod.pose(2, k) == Approx(on_line.z()));
    CHECK(std::abs(rod.pose(1, k) - on_line.y()) > 1e-3);
  }
  CHECK_THROWS_AS(pipeline::refined(design, 0), std::invalid_argument);
}

TEST_CASE("refining once is the same design") {
  const io::Design design = ring(20);
  CHECK(io::design_text(pipeline::refined(design, 1)) == io::design_text(design));
}
