#include <catch2/catch.hpp>
#include <tencer/der/energy.hpp>

using namespace tencer::der;

namespace {

Rod random_rod(bool closed, int vertices) {
  const int edges = closed ? vertices : vertices - 1;
  return {
      .closed = closed,
      .section = {.EA = 30.0, .EI1 = 1.3, .EI2 = 1.3, .GJ = 0.9},
      .rest_lengths = Eigen::VectorXd::Constant(edges, 1.0) + 0.3 * Eigen::VectorXd::Random(edges)};
}

// A bent curve without folds, off its rest lengths.
RodState random_state(const Rod& rod) {
  const int n = rod.vertices();
  Eigen::Matrix3Xd x(3, n);
  for (int i = 0; i < n; ++i) {
    const double phi = 2 * 3.14159265 * i / n;
    x.col(i) = 0.18 * n * Eigen::Vector3d(std::cos(phi), std::sin(phi), 0.3 * std::sin(2 * phi));
  }
  x += 0.1 * Eigen::Matrix3Xd::Random(3, n);
  return make_state(rod, x);
}

Eigen::VectorXd gradient(const Rod& rod, const RodState& state) {
  Eigen::VectorXd g = Eigen::VectorXd::Zero(unknowns(rod));
  add_gradient(rod, state, g);
  return g;
}

Eigen::MatrixXd dense_hessian(const Rod& rod, const RodState& state) {
  const auto lists = elements(rod);
  Eigen::MatrixXd h = Eigen::MatrixXd::Zero(unknowns(rod), unknowns(rod));
  hessian(rod, state, axial_forces(rod, state.x), [&](int element, const double* matrix) {
    const auto& list = lists[element];
    for (std::size_t b = 0; b < list.size(); ++b)
      for (std::size_t a = 0; a < list.size(); ++a)
        h(list[a], list[b]) += matrix[a + b * list.size()];
  });
  return h;
}

RodState moved(const Rod& rod, RodState state, const Eigen::VectorXd& step) {
  displace(rod, state, step);
  return state;
}

}  // namespace

TEST_CASE("gradient and Hessian match central differences") {
  std::srand(1);
  const bool closed = GENERATE(false, true);
  const Rod rod = random_rod(closed, 9);
  const RodState state = random_state(rod);
  const Eigen::VectorXd g = gradient(rod, state);
  const Eigen::MatrixXd h = dense_hessian(rod, state);
  const double step = 1e-5;
  for (int i = 0; i < unknowns(rod); ++i) {
    const Eigen::VectorXd d = step * Eigen::VectorXd::Unit(unknowns(rod), i);
    const RodState plus = moved(rod, state, d);
    const RodState minus = moved(rod, state, -d);
    CHECK(g[i] ==
          Approx((energy(rod, plus) - energy(rod, minus)) / (2 * step)).margin(1e-8 * g.norm()));
    const Eigen::VectorXd column = (gradient(rod, plus) - gradient(rod, minus)) / (2 * step);
    CHECK((h.col(i) - column).norm() < 1e-8 * h.norm());
  }
  CHECK((h - h.transpose()).norm() < 1e-13 * h.norm());
}

TEST_CASE("the third derivative matches differences of the Hessian") {
  std::srand(2);
  const Rod rod = random_rod(GENERATE(false, true), 8);
  const RodState state = random_state(rod);
  const Eigen::VectorXd v = Eigen::VectorXd::Random(unknowns(rod));
  const Eigen::VectorXd w = Eigen::VectorXd::Random(unknowns(rod));
  const double step = 1e-5;
  const Eigen::VectorXd difference = (dense_hessian(rod, moved(rod, state, step * v)) -
                                      dense_hessian(rod, moved(rod, state, -step * v))) *
                                     w / (2 * step);
  CHECK((third_derivative(rod, state, v, w) - difference).norm() < 1e-8 * difference.norm());
}

TEST_CASE("bending keeps its digits at nearly straight vertices") {
  Rod rod{.closed = false,
          .section = {.EA = 1.0, .EI1 = 2.0, .EI2 = 2.0, .GJ = 1.0},
          .rest_lengths = Eigen::Vector2d(1.0, 1.0)};
  const double angle = 1e-9;
  Eigen::Matrix3Xd x(3, 3);
  x << -1, 0, std::cos(angle), 0, 0, std::sin(angle), 0, 0, 0;
  // |kb| = 2 tan(angle / 2).
  CHECK(energy(rod, make_state(rod, x)) == Approx(angle * angle).epsilon(1e-6));
}

TEST_CASE("a folded vertex has infinite energy") {
  Rod rod{.closed = false, .section = {}, .rest_lengths = Eigen::Vector2d(1.0, 1.0)};
  Eigen::Matrix3Xd x(3, 3);
  x << -1, 0, -1, 0, 0, 0, 0, 0, 0;
  CHECK(std::isinf(energy(rod, make_state(rod, x))));
}
