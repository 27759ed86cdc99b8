// Designs with finer rods.
#include <catch2/catch.hpp>
#include <tencer/model/subdivision.hpp>

using namespace tencer;

TEST_CASE("refining keeps lengths, vertices, bends at rest and supports") {
  model::Design design;
  der::Rod open{.section = {}, .rest_lengths = Eigen::Vector4d(1, 2, 1, 3)};
  open.rest_curvature = Eigen::Matrix2Xd::Constant(2, 3, 0.1);
  open.rest_curvature.array().rowwise() *= Eigen::RowVector3d(1.5, 1.5, 2).array();
  const Eigen::Matrix3Xd target = Eigen::Matrix3Xd::Random(3, 5);
  const Eigen::Matrix3Xd pose = Eigen::Matrix3Xd::Random(3, 5);
  const Eigen::Matrix3Xd directors = Eigen::Matrix3Xd::Random(3, 4);
  design.structure.rods = {open};
  design.target = {target};
  design.pose = {pose};
  design.target_directors = {Eigen::Matrix3Xd(3, 0)};
  design.pose_directors = {directors};
  design.structure.pins = {{.rod = 0, .vertex = 0, .axes = {true, true, true}},
                           {.rod = 0, .vertex = 1, .axes = {true, false, true}},
                           {.rod = 0, .vertex = 4, .axes = {false, true, false}}};
  design.structure.point_loads = {{.rod = 0, .s = 2.5, .force = {1, 2, 3}}};
  const model::Design fine = model::subdivided(design, 3);
  const der::Rod& rod = fine.structure.rods[0];
  CHECK(rod.length() == Approx(7));
  CHECK(rod.rest_lengths[4] == Approx(2.0 / 3));
  REQUIRE(fine.pose[0].cols() == 13);
  for (int i = 0; i < 5; ++i) {
    CHECK(fine.pose[0].col(3 * i) == pose.col(i));
    CHECK(fine.target[0].col(3 * i) == target.col(i));
  }
  // 0.1 per length everywhere.
  REQUIRE(rod.rest_curvature.cols() == 11);
  CHECK(rod.rest_curvature(0, 0) == Approx(0.1 / 3));
  CHECK(rod.rest_curvature(1, 2) == Approx(0.1 * (1.0 / 3 + 2.0 / 3) / 2));
  CHECK(fine.pose_directors[0].col(5) == directors.col(1));
  CHECK(fine.structure.point_loads[0].s == 2.5);

  // x and z are held along the first edge, and straight there.
  const auto& pins = fine.structure.pins;
  REQUIRE(pins.size() == 5);
  CHECK(pins[1].vertex == 3);
  CHECK(pins[2].vertex == 12);
  for (int k = 1; k < 3; ++k) {
    CHECK(pins[2 + k].vertex == k);
    CHECK(pins[2 + k].axes == std::array{true, false, true});
    const Eigen::Vector3d on_line = pose.col(0) + k / 3.0 * (pose.col(1) - pose.col(0));
    CHECK(fine.pose[0](0, k) == Approx(on_line.x()));
    CHECK(fine.pose[0](2, k) == Approx(on_line.z()));
    CHECK(std::abs(fine.pose[0](1, k) - on_line.y()) > 1e-3);
  }
  CHECK_THROWS_AS(model::subdivided(design, 0), std::invalid_argument);
}
