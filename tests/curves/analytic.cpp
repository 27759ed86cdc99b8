#include <Eigen/Geometry>
#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>
#include <tencer/curves/analytic.hpp>

using namespace tencer::curves;
using std::numbers::pi;
using tencer::geometry::Polyline;

namespace {

double length_of(const Polyline& curve) { return edge_lengths(curve).sum(); }

// Linking number of two closed polygons: the signed solid angles of all pairs of edges over 4 pi.
double linking_number(const Polyline& a, const Polyline& b) {
  const auto solid_angle = [](const Eigen::Vector3d& p, const Eigen::Vector3d& q,
                              const Eigen::Vector3d& r) {
    const double x = p.norm(), y = q.norm(), z = r.norm();
    return 2 *
           std::atan2(p.dot(q.cross(r)), x * y * z + p.dot(q) * z + q.dot(r) * x + r.dot(p) * y);
  };
  double sum = 0;
  for (int i = 0; i < a.vertices(); ++i)
    for (int j = 0; j < b.vertices(); ++j) {
      const Eigen::Vector3d p = a.points.col(i), q = a.points.col((i + 1) % a.vertices());
      const Eigen::Vector3d r = b.points.col(j), s = b.points.col((j + 1) % b.vertices());
      sum += solid_angle(r - p, s - p, s - q) + solid_angle(r - p, s - q, r - q);
    }
  return sum / (4 * pi);
}

}  // namespace

TEST_CASE("curves have the known lengths of circle, ellipse and helix") {
  // A chord of angle h is shorter than its arc by h^2/24.
  const double step = 2 * pi / 400;
  CHECK(length_of(circle(3, 400)) == Approx(2 * pi * 3 * (1 - step * step / 24)).epsilon(1e-9));
  CHECK(length_of(ellipse(2, 1, 2000)) ==
        Approx(4 * 2 * std::comp_ellint_2(std::sqrt(0.75))).epsilon(2e-6));
  CHECK(length_of(helix(50, 33, 1.5, 2000)) ==
        Approx(1.5 * std::hypot(pi * 50, 33.0)).epsilon(1e-6));
  for (const TrefoilForm form :
       {TrefoilForm::hypotrochoid, TrefoilForm::torus_2_3, TrefoilForm::torus_3_2})
    CHECK(length_of(trefoil(form, 198, 4000)) == Approx(198).epsilon(1e-5));
}

TEST_CASE("a torus knot lies on its torus and winds p and q times") {
  const int p = 5, q = 3;
  const Polyline knot = torus_knot(p, q, 13.5, 5.4, 600);
  double about_axis = 0, about_circle = 0;
  const auto angles = [&](int i) {
    const Eigen::Vector3d x = knot.points.col(i % 600);
    const double distance = std::hypot(x[0], x[1]);
    CHECK(std::hypot(distance - 13.5, x[2]) == Approx(5.4).epsilon(1e-12));
    return Eigen::Vector2d(std::atan2(x[1], x[0]), std::atan2(x[2], distance - 13.5));
  };
  for (int i = 0; i < 600; ++i) {
    const Eigen::Vector2d step = angles(i + 1) - angles(i);
    about_axis += std::remainder(step[0], 2 * pi);
    about_circle += std::remainder(step[1], 2 * pi);
  }
  CHECK(about_axis == Approx(2 * pi * p));
  CHECK(about_circle == Approx(2 * pi * q));
}

TEST_CASE("trefoils have threefold symmetry, and a hypotrochoid for a shadow") {
  const auto turned = [](const Polyline& curve, double angle) -> Eigen::Matrix3Xd {
    return Eigen::AngleAxisd(angle, Eigen::Vector3d::UnitZ()).toRotationMatrix() * curve.points;
  };
  const int third = 34;
  for (const TrefoilForm form : {TrefoilForm::hypotrochoid, TrefoilForm::torus_2_3}) {
    const Polyline curve = trefoil(form, 198, 3 * third);
    // The turn by 120 degrees moves every vertex on by a third of the curve, one way or the other.
    double nearest = 1e300;
    for (const double angle : {2 * pi / 3, -2 * pi / 3}) {
      const Eigen::Matrix3Xd points = turned(curve, angle);
      double worst = 0;
      for (int i = 0; i < 3 * third; ++i)
        worst =
            std::max(worst, (points.col(i) - curve.points.col((i + third) % (3 * third))).norm());
      nearest = std::min(nearest, worst);
    }
    CHECK(nearest < 1e-6);
  }
  // A wheel of radius 4 in a ring of radius 6, pen at 1: x + iy = 2 e^{2ia} + e^{-ia} up to the
  // choice of axes, so the distance from the axis is between 1 and 3 units.
  const Polyline curve = trefoil(TrefoilForm::hypotrochoid, 198, 3000);
  const Eigen::VectorXd distance = curve.points.topRows<2>().colwise().norm().transpose();
  CHECK(distance.maxCoeff() / distance.minCoeff() == Approx(3).epsilon(1e-4));
  CHECK(distance.minCoeff() == Approx(curve.points.row(2).maxCoeff()).epsilon(1e-4));
}

TEST_CASE("twin trefoils are one curve turned by 60 degrees") {
  const auto twins = twin_trefoils(27, 10.8, 102);
  REQUIRE(twins.size() == 2);
  const Eigen::Matrix3d turn =
      Eigen::AngleAxisd(pi / 3, Eigen::Vector3d::UnitZ()).toRotationMatrix();
  CHECK((turn * twins[0].points - twins[1].points).cwiseAbs().maxCoeff() < 1e-13);
  CHECK(length_of(twins[0]) == Approx(398).epsilon(0.005));  // table 1
}

TEST_CASE("Borromean ellipses are linked together but not two by two") {
  const auto rings = borromean_ellipses(6.5, 5, 100);
  REQUIRE(rings.size() == 3);
  CHECK(length_of(rings[0]) == Approx(36.28).epsilon(0.001));  // table 1: 36
  for (int i = 0; i < 3; ++i) CHECK(std::abs(linking_number(rings[i], rings[(i + 1) % 3])) < 1e-9);
  // Every ring's disk is pierced by the next ring on both sides of the disk's centre, which is what
  // holds them together: the ring's short axis end lies inside the other's long axis end.
  for (int i = 0; i < 3; ++i) {
    const double reach = rings[i].points.row((i + 1) % 3).cwiseAbs().maxCoeff();
    const double gap = rings[(i + 1) % 3].points.row((i + 1) % 3).cwiseAbs().maxCoeff();
    CHECK(reach == Approx(5).epsilon(0.01));
    CHECK(gap == Approx(6.5).epsilon(0.01));
  }
}

TEST_CASE("linking number check sees a Hopf link") {
  Polyline first = circle(1, 50), second = circle(1, 50);
  second.points.row(2) = second.points.row(1);
  second.points.row(1).setZero();
  second.points.row(0).array() += 1;
  CHECK(std::abs(linking_number(first, second)) == Approx(1));
}

TEST_CASE("a helix rises by its pitch each turn and starts on the x axis") {
  const Polyline curve = helix(50, 33, 1.5, 100);
  CHECK((curve.points.col(0) - Eigen::Vector3d(25, 0, 0)).norm() < 1e-12);
  CHECK((curve.points.col(99) - Eigen::Vector3d(-25, 0, 49.5)).norm() < 1e-9);
}

TEST_CASE("windings with a common divisor are the caller's mistake") {
  CHECK_THROWS_AS(torus_knot(4, 2, 2, 1, 100), std::invalid_argument);
}
