#include <catch2/catch.hpp>
#include <numbers>
#include <tencer/model/frames.hpp>
#include <tencer/model/scene.hpp>
#include <tencer/model/vertex_fields.hpp>

using namespace tencer;

namespace {

geometry::Polyline arc(double radius, double angle, int vertices, bool closed) {
  geometry::Polyline curve{Eigen::Matrix3Xd(3, vertices), closed};
  for (int i = 0; i < vertices; ++i) {
    const double t = angle * i / (closed ? vertices : vertices - 1);
    curve.points.col(i) << radius * std::cos(t), radius * std::sin(t), 0.0;
  }
  return curve;
}

// A rod straight at rest, as long as the curve, that stands in this pose.
model::Design design_of(const geometry::Polyline& curve, const der::Section& section) {
  model::Scene scene;
  add_rod(scene, curve);
  model::Design design;
  design.structure = scene.structure;
  design.structure.rods[0].section = section;
  design.target = design.pose = scene.target.points;
  design.target_directors = design.pose_directors = {Eigen::Matrix3Xd(3, 0)};
  return design;
}

}  // namespace

TEST_CASE("the fields of a ring are those of a circle all along") {
  const auto design =
      design_of(arc(5, 2 * std::numbers::pi, 400, true), der::solid_circle(1e6, 0.3, 0.1));
  const auto fields = vertex_fields(design);
  REQUIRE(fields.size() == 1);
  CHECK(fields[0].deviation.norm() == 0);
  CHECK((fields[0].curvature.array() - 1 / 5.0).abs().maxCoeff() < 1e-4);
  REQUIRE(fields[0].strain);
  CHECK((fields[0].strain->array() - 0.1 / 5.0).abs().maxCoeff() < 1e-5);
  CHECK(fields[0].tension.cwiseAbs().maxCoeff() < 1e-6 * design.structure.rods[0].section.EA);
}

TEST_CASE("the deviation points from the target to the pose") {
  auto design = design_of(arc(5, 2, 30, false), {});
  design.pose[0].col(7) += Eigen::Vector3d(0, 0, 0.5);
  const auto deviation = vertex_fields(design)[0].deviation;
  CHECK((deviation.col(7) - Eigen::Vector3d(0, 0, 0.5)).norm() < 1e-14);
  CHECK(deviation.col(8).norm() == 0);
}

TEST_CASE("nothing bends at the ends of an open rod, and without a shape no strain is known") {
  const auto fields = vertex_fields(design_of(arc(5, 2, 30, false), {}));
  CHECK(fields[0].curvature[0] == 0);
  CHECK(fields[0].curvature[29] == 0);
  CHECK(fields[0].curvature[1] == Approx(0.2).epsilon(1e-3));
  CHECK_FALSE(fields[0].strain);
}

TEST_CASE("a rod that is longer than at rest is in tension, and its ends as their edges") {
  auto design = design_of(arc(5, 2, 11, false), der::solid_circle(1e6, 0.3, 0.1));
  der::Rod& rod = design.structure.rods[0];
  rod.rest_lengths[0] /= 1.01;  // so much shorter than in the pose
  const auto tension = vertex_fields(design)[0].tension;
  CHECK(tension[0] == Approx(0.01 * rod.section.EA));
  CHECK(tension[1] == Approx(0.005 * rod.section.EA));
  CHECK(tension[10] == Approx(0).margin(1e-9 * rod.section.EA));
}

TEST_CASE("a flat strip's strain depends on how it is turned") {
  auto design = design_of(arc(5, 2, 60, false), der::rectangle(1e6, 0.3, 0.4, 0.1));
  CHECK_FALSE(vertex_fields(design)[0].strain);  // nobody says
  const auto strain_with = [&](const Eigen::Vector3d& m1) {
    design.pose_directors[0] = m1.replicate(1, 59);
    return (*vertex_fields(design)[0].strain)[30];
  };
  // Its width across the bend: the outer fibres are half its height away.
  CHECK(strain_with(Eigen::Vector3d::UnitZ()) == Approx(0.05 / 5).epsilon(1e-2));
  CHECK_FALSE(vertex_fields(design)[0].curvature[30] == Approx(0));
}
