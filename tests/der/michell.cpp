// Michell 1889: a ring closed after turning one end by Theta leaves its plane at Theta = 2 pi
// sqrt(3) EI / GJ.
#include <Eigen/Dense>
#include <catch2/catch.hpp>
#include <numbers>

#include "eigenvalues.hpp"
#include "fixtures.hpp"

using namespace tencer::der;
using std::numbers::pi;

namespace {

constexpr double EI = 1.0;
constexpr double GJ = 0.8;
const double michell = 2 * pi * std::sqrt(3.0) * EI / GJ;

// A regular polygon of circumradius 1 at rest: the edges, all but inextensible, are as much longer
// than the sides as bending compresses them.
Rod balanced_ring(int n, const Eigen::Matrix3Xd& x) {
  const double side = 2 * std::sin(pi / n);
  Rod rod{.closed = true,
          .section = {.EA = 1e7, .EI1 = EI, .EI2 = EI, .GJ = GJ},
          .rest_lengths = Eigen::VectorXd::Constant(n, side)};
  // The gradient is radial; each edge's force pulls on a vertex by 2 sin(pi / n) towards the
  // centre.
  const double radial = gradient(rod, make_state(rod, x)).head<3>().dot(x.col(0));
  rod.rest_lengths.setConstant(side / (1 - radial / (2 * std::sin(pi / n)) / rod.section.EA));
  return rod;
}

// Of the Hessian on motions other than rigid ones and, with an angle per edge, the spinning of the
// whole rod about itself.
double smallest_eigenvalue(const Rod& rod, const RodState& state) {
  const Eigen::MatrixXd h = energy_hessian(rod, state);
  const bool framed = twist_model(rod) == TwistModel::per_edge;
  Eigen::MatrixXd free = Eigen::MatrixXd::Zero(h.rows(), framed ? 7 : 6);
  for (int axis = 0; axis < 3; ++axis) {
    for (int i = 0; i < rod.vertices(); ++i) free(3 * i + axis, axis) = 1;
    free.col(3 + axis) = rotation_step(rod, state, Eigen::Vector3d::Unit(axis)).head(h.rows());
  }
  if (framed) free.col(6).tail(rod.edges()).setOnes();
  const Eigen::MatrixXd q = free.householderQr().householderQ();
  const Eigen::MatrixXd others = q.rightCols(h.rows() - free.cols());
  return tencer::test::eigenvalues(others.transpose() * h * others)[0];
}

double critical_angle(int n, bool per_edge) {
  Eigen::Matrix3Xd x(3, n);
  for (int i = 0; i < n; ++i) x.col(i) << std::cos(2 * pi * i / n), std::sin(2 * pi * i / n), 0;
  Rod rod = balanced_ring(n, x);
  if (per_edge) force_per_edge(rod);
  const auto stiffness_at = [&](double angle) {
    rod.closing_angle = angle;
    const RodState state = make_state(rod, x);
    REQUIRE(gradient(rod, state).norm() < 1e-6);
    return smallest_eigenvalue(rod, state);
  };
  // Secants from the smooth ring's angle: a polygon holds out a little longer.
  double stable = michell;
  double unstable = 1.2 * michell;
  double positive = stiffness_at(stable);
  double negative = stiffness_at(unstable);
  REQUIRE(positive > 0);
  REQUIRE(negative < 0);
  while (unstable - stable > 1e-6 * michell) {
    const double angle = (stable * negative - unstable * positive) / (negative - positive);
    const double value = stiffness_at(angle);
    if (std::abs(value) < 1e-7) return angle;
    (value > 0 ? stable : unstable) = angle;
    (value > 0 ? positive : negative) = value;
  }
  return stable;
}

}  // namespace

TEST_CASE("a twisted ring leaves its plane at Michell's angle") {
  const bool per_edge = GENERATE(false, true);
  const double coarse = critical_angle(20, per_edge) / michell - 1;
  const double fine = critical_angle(40, per_edge) / michell - 1;
  CHECK(std::abs(fine) < 0.025);
  CHECK(coarse / fine == Approx(4.0).epsilon(0.05));
  CHECK(std::abs(fine + (fine - coarse) / 3) < 1e-3);
}
