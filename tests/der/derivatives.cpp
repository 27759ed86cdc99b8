#include <Eigen/Geometry>
#include <catch2/catch.hpp>

#include "fixtures.hpp"

using namespace tencer::der;

namespace {

// By how much the derivative of a per-edge rod's gradient exceeds the Hessian, see displace: for
// each edge dE/dtheta / (2 |e|^2) (e / |e|) x, on the difference of its end points.
Eigen::MatrixXd detour_of_steps(const Rod& rod, const RodState& state) {
  const int n = rod.vertices();
  Eigen::MatrixXd excess = Eigen::MatrixXd::Zero(unknowns(rod), unknowns(rod));
  if (twist_model(rod) != TwistModel::per_edge) return excess;
  const Eigen::VectorXd g = gradient(rod, state);
  for (int j = 0; j < rod.edges(); ++j) {
    const int k = (j + 1) % n;
    const Eigen::Vector3d e = state.x.col(k) - state.x.col(j);
    Eigen::Matrix3d cross;
    cross << 0, -e.z(), e.y(), e.z(), 0, -e.x(), -e.y(), e.x(), 0;
    cross *= g[3 * n + j] / (2 * std::pow(e.norm(), 3));
    excess.block<3, 3>(3 * j, 3 * j) += cross;
    excess.block<3, 3>(3 * k, 3 * k) += cross;
    excess.block<3, 3>(3 * j, 3 * k) -= cross;
    excess.block<3, 3>(3 * k, 3 * j) -= cross;
  }
  return excess;
}

// d3/da3 of the energy along a v: the tangents of each edge sweep one great circle, on which steps
// add up exactly, so differences of the Hessian along v give it.
double third_along(const Rod& rod, const RodState& state, const Eigen::VectorXd& v) {
  const double step = 1e-5;
  return v.dot((dense_hessian(rod, moved(rod, state, step * v)) -
                dense_hessian(rod, moved(rod, state, -step * v))) *
               v) /
         (2 * step);
}

}  // namespace

TEST_CASE("gradient and Hessian match central differences") {
  std::srand(1);
  for (const auto& [name, rod] : rods_of_every_model(9)) {
    INFO(name);
    const RodState state = random_state(rod);
    const Eigen::VectorXd g = gradient(rod, state);
    const Eigen::MatrixXd h = energy_hessian(rod, state);
    const Eigen::MatrixXd detour = detour_of_steps(rod, state).topLeftCorner(h.rows(), h.cols());
    const double step = 1e-5;
    for (int i = 0; i < h.rows(); ++i) {
      const Eigen::VectorXd d = step * Eigen::VectorXd::Unit(unknowns(rod), i);
      const RodState plus = moved(rod, state, d);
      const RodState minus = moved(rod, state, -d);
      CHECK(g[i] ==
            Approx((energy(rod, plus) - energy(rod, minus)) / (2 * step)).margin(1e-8 * g.norm()));
      const Eigen::VectorXd column = (gradient(rod, plus) - gradient(rod, minus)) / (2 * step);
      CHECK((h.col(i) + detour.col(i) - column.head(h.rows())).norm() < 1e-8 * h.norm());
    }
    CHECK((h - h.transpose()).norm() < 1e-13 * h.norm());
  }
}

TEST_CASE("the Hessian is the energy's second difference along a displacement") {
  std::srand(3);
  for (const auto& [name, rod] : rods_of_every_model(7)) {
    INFO(name);
    const RodState state = random_state(rod);
    const Eigen::MatrixXd h = energy_hessian(rod, state);
    const Eigen::VectorXd v = Eigen::VectorXd::Random(unknowns(rod));
    const double step = 1e-4;
    const double difference = (energy(rod, moved(rod, state, step * v)) - 2 * energy(rod, state) +
                               energy(rod, moved(rod, state, -step * v))) /
                              (step * step);
    const Eigen::VectorXd u = v.head(h.rows());
    CHECK(u.dot(h * u) == Approx(difference).epsilon(1e-6));
  }
}

TEST_CASE("the third derivative matches differences of the Hessian") {
  std::srand(2);
  for (const auto& [name, rod] : rods_of_every_model(8)) {
    INFO(name);
    const RodState state = random_state(rod);
    Eigen::VectorXd v = Eigen::VectorXd::Random(unknowns(rod));
    const Eigen::VectorXd w = Eigen::VectorXd::Random(unknowns(rod));
    Eigen::VectorXd difference(unknowns(rod));
    if (twist_model(rod) == TwistModel::per_edge) {
      // 24 times the mixed value from values along one vector each.
      for (int i = 0; i < unknowns(rod); ++i) {
        const Eigen::VectorXd z = Eigen::VectorXd::Unit(unknowns(rod), i);
        difference[i] = (third_along(rod, state, v + w + z) - third_along(rod, state, v + w - z) -
                         third_along(rod, state, v - w + z) - third_along(rod, state, w - v + z)) /
                        24;
      }
    } else {
      // The Hessian at a moved state has the moment of that state.
      if (twist_model(rod) == TwistModel::uniform) {
        const auto m = v.size() - 1;
        const Eigen::MatrixXd h = dense_hessian(rod, state);
        v[m] = -h.row(m).head(m).dot(v.head(m)) / h(m, m);
      }
      const double step = 1e-5;
      difference = (dense_hessian(rod, moved(rod, state, step * v)) -
                    dense_hessian(rod, moved(rod, state, -step * v))) *
                   w / (2 * step);
    }
    const Eigen::VectorXd third = third_derivative(rod, state, v, w);
    CHECK((third - difference).norm() < 1e-7 * difference.norm());
    CHECK((third - third_derivative(rod, state, w, v)).norm() < 1e-12 * third.norm());
  }
}

TEST_CASE("rigid motion does no work and costs no energy") {
  std::srand(4);
  for (const auto& [name, rod] : rods_of_every_model(8)) {
    INFO(name);
    const RodState state = random_state(rod);
    const Eigen::VectorXd g = gradient(rod, state);
    const Eigen::MatrixXd h = energy_hessian(rod, state);
    const auto size = h.rows();
    for (int axis = 0; axis < 3; ++axis) {
      Eigen::VectorXd shift = Eigen::VectorXd::Zero(unknowns(rod));
      for (int i = 0; i < rod.vertices(); ++i) shift[3 * i + axis] = 1;
      CHECK(std::abs(g.dot(shift)) < 1e-12 * g.norm() * shift.norm());
      CHECK((h * shift.head(size)).norm() < 1e-12 * h.norm() * shift.norm());
    }
    const Eigen::Vector3d omega = Eigen::Vector3d::Random();
    const Eigen::VectorXd turn = rotation_step(rod, state, omega);
    CHECK(std::abs(g.dot(turn)) < 1e-12 * g.norm() * turn.norm());
    // A finite rotation by angle a is a turn + a^2 / 2 omega x (omega x x) + ..., and keeps the
    // energy to every order.
    double outward = 0;
    for (int i = 0; i < rod.vertices(); ++i)
      outward += g.segment<3>(3 * i).dot(omega.cross(omega.cross(Eigen::Vector3d(state.x.col(i)))));
    const Eigen::VectorXd u = turn.head(size);
    CHECK(u.dot(h * u) == Approx(-outward).margin(1e-12 * h.norm() * u.squaredNorm()));

    const double angle = 0.3;
    const Eigen::Matrix3d rotation =
        Eigen::AngleAxisd(angle, omega.normalized()).toRotationMatrix();
    RodState rotated = state;
    rotated.x = rotation * state.x;
    rotated.frames.tangent = rotation * state.frames.tangent;
    rotated.frames.director = rotation * state.frames.director;
    CHECK(energy(rod, rotated) == Approx(energy(rod, state)).epsilon(1e-12));
  }
}

TEST_CASE("bending keeps its digits at nearly straight vertices") {
  Rod rod{.closed = false,
          .section = {.EA = 1.0, .EI1 = 2.0, .EI2 = 2.0, .GJ = 1.0},
          .rest_lengths = Eigen::Vector2d(1.0, 1.0)};
  if (GENERATE(false, true)) force_per_edge(rod);
  const double angle = 1e-9;
  Eigen::Matrix3Xd x(3, 3);
  x << -1, 0, std::cos(angle), 0, 0, std::sin(angle), 0, 0, 0;
  // |kb| = 2 tan(angle / 2).
  CHECK(energy(rod, make_state(rod, x)) == Approx(angle * angle).epsilon(1e-6));
}

TEST_CASE("a folded vertex has infinite energy") {
  Rod rod{.closed = false, .section = {}, .rest_lengths = Eigen::Vector2d(1.0, 1.0)};
  if (GENERATE(false, true)) rod.section.EI2 = 2.0;
  Eigen::Matrix3Xd x(3, 3);
  x << -1, 0, -1, 0, 0, 0, 0, 0, 0;
  CHECK(std::isinf(energy(rod, make_state(rod, x))));
}

TEST_CASE("an edge without length has infinite energy") {
  for (const auto& [name, rod] : rods_of_every_model(6)) {
    CAPTURE(name);
    for (int edge = 0; edge < rod.edges(); ++edge) {
      Eigen::Matrix3Xd x = random_state(rod).x;
      x.col((edge + 1) % 6) = x.col(edge);
      CHECK(std::isinf(energy(rod, make_state(rod, x))));
    }
  }
}

TEST_CASE("the bending force on an edge is perpendicular to it also in a fold") {
  // What is left along an edge would be a force that stretches it.
  for (const double gap : {1e-2, 1e-5, 1e-8}) {
    const Rod rod{.section = {.EA = 1e-12, .EI1 = 1, .EI2 = 1, .GJ = 1},
                  .rest_lengths = Eigen::Vector2d(0.5, 0.5)};
    Eigen::Matrix3Xd x(3, 3);
    x << 0, gap / 4, gap / 2, 0, std::sqrt(0.25 - gap * gap / 16), 0, 0, 0, 0;
    const Eigen::VectorXd g = gradient(rod, make_state(rod, x));
    CAPTURE(gap);
    const Eigen::Vector3d along = (x.col(1) - x.col(0)).normalized();
    CHECK(std::abs(along.dot(g.head<3>())) < 4e-16 * g.head<3>().norm());
  }
}
