// The model's predictions against what they stand for, worked out another way.
#include "model/gauss_newton_model.hpp"

#include <Eigen/Dense>
#include <catch2/catch.hpp>
#include <random>

using namespace tencer;
using elimination::GaussNewtonModel;
using elimination::LocalModel;
using elimination::Norm;
using elimination::Squares;
using elimination::StepBounds;

namespace {

// Random numbers that are the same everywhere.
class Numbers {
 public:
  explicit Numbers(unsigned seed) : engine_(seed) {}
  double operator()() { return static_cast<double>(engine_()) / 2147483648.0 - 1.0; }
  Eigen::MatrixXd matrix(Eigen::Index rows, Eigen::Index columns) {
    return Eigen::MatrixXd::NullaryExpr(rows, columns, [&] { return (*this)(); });
  }

 private:
  std::mt19937 engine_;
};

struct Case {
  LocalModel local{};
  Squares further{};
  Eigen::VectorXd damping{};
  StepBounds bounds{};
};

// vertices with a residual, `orbits` cables with three variables each.
Case random_case(unsigned seed, int vertices, int orbits, double damping) {
  Numbers numbers(seed);
  const Eigen::Index variables = 3 * orbits;
  Case made;
  made.local.ties.resize(variables, variables);
  made.local.ties.setIdentity();
  made.local.distance.residual = numbers.matrix(3 * vertices, 1);
  made.local.distance.jacobian = numbers.matrix(3 * vertices, variables);
  made.local.density = numbers.matrix(orbits, 1).cwiseAbs().array() + 0.5;
  made.local.density_rates = numbers.matrix(orbits, variables);
  made.further = {.value = numbers.matrix(3, 1), .rates = numbers.matrix(3, variables)};
  made.damping = Eigen::VectorXd::Constant(variables, damping);
  made.bounds.rows = Eigen::MatrixXd::Zero(orbits, variables);
  made.bounds.rows.topRows(orbits) = made.local.density_rates;
  made.bounds.lower = -0.8 * made.local.density;
  return made;
}

GaussNewtonModel model_of(const Case& made, const Norm& norm = {}) {
  return {made.local, norm, made.further, made.damping, made.bounds};
}

// The objective with norm {1, 2}: the mean of |r_i|^2 over the vertices, and the further squares.
struct FullObjective {
  Eigen::MatrixXd rows;
  Eigen::VectorXd values;

  explicit FullObjective(const Case& made) {
    const double vertices = static_cast<double>(made.local.distance.residual.size()) / 3;
    const Eigen::Index n = made.local.distance.residual.size();
    rows.resize(n + made.further.value.size(), made.local.ties.cols());
    values.resize(rows.rows());
    rows << made.local.distance.jacobian / std::sqrt(vertices), made.further.rates;
    values << made.local.distance.residual / std::sqrt(vertices), made.further.value;
  }
  double operator()(const Eigen::VectorXd& z) const { return (values + rows * z).squaredNorm(); }
};

// argmin |values + rows z|^2 + sum damping z^2 under equalities a z = b, by its KKT system.
Eigen::VectorXd constrained(const FullObjective& objective, const Eigen::VectorXd& damping,
                            const Eigen::MatrixXd& a, const Eigen::VectorXd& b) {
  const Eigen::Index n = damping.size();
  Eigen::MatrixXd kkt = Eigen::MatrixXd::Zero(n + a.rows(), n + a.rows());
  kkt.topLeftCorner(n, n) = objective.rows.transpose() * objective.rows;
  kkt.topLeftCorner(n, n).diagonal() += damping;
  kkt.topRightCorner(n, a.rows()) = a.transpose();
  kkt.bottomLeftCorner(a.rows(), n) = a;
  Eigen::VectorXd right(n + a.rows());
  right << -(objective.rows.transpose() * objective.values), b;
  return kkt.fullPivLu().solve(right).head(n);
}

}  // namespace

TEST_CASE("the predicted cost of a removal is that of the refit with the cable's density at zero") {
  for (const unsigned seed : {1u, 2u, 3u}) {
    // Without damping the prediction is exact.
    const Case made = random_case(seed, 20, 4, 1e-13);
    const FullObjective objective(made);
    const Eigen::VectorXd costs = model_of(made).removal_costs();
    for (Eigen::Index o = 0; o < 4; ++o) {
      const Eigen::VectorXd refit =
          constrained(objective, made.damping, made.local.density_rates.row(o),
                      Eigen::VectorXd::Constant(1, -made.local.density[o]));
      CHECK(costs[o] == Approx(objective(refit)).epsilon(1e-8));
    }
  }
}

TEST_CASE("a step takes the densities asked for to zero, and all others are refitted") {
  const Case made = random_case(4, 20, 5, 1e-3);
  Case unbounded = made;
  unbounded.bounds.lower.setConstant(-1e6);
  const FullObjective objective(made);
  const std::vector<int> out{1, 3};
  const Eigen::VectorXd step = model_of(unbounded).step(out);
  const Eigen::VectorXd expected = constrained(
      objective, made.damping, made.local.density_rates(out, Eigen::all), -made.local.density(out));
  CHECK((step - expected).norm() < 1e-9 * expected.norm());
  // A part of the way takes a part of the densities.
  const Eigen::VectorXd half = model_of(unbounded).step(out, 0.5);
  CHECK((made.local.density_rates(out, Eigen::all) * half + 0.5 * made.local.density(out)).norm() <
        1e-9);
}

TEST_CASE("a step within bounds solves the quadratic program") {
  // Every set of active bounds is tried, and the best step that keeps all bounds wins.
  for (const unsigned seed : {5u, 6u, 7u, 8u}) {
    Case made = random_case(seed, 12, 4, 1e-2);
    made.bounds.lower = -0.05 * made.local.density;  // tight, so that bounds matter
    const FullObjective objective(made);
    const auto value = [&](const Eigen::VectorXd& z) {
      return objective(z) + made.damping.dot(z.cwiseAbs2());
    };
    Eigen::VectorXd best;
    for (int set = 0; set < 16; ++set) {
      std::vector<int> active;
      for (int i = 0; i < 4; ++i)
        if ((set >> i & 1) != 0) active.push_back(i);
      const Eigen::VectorXd z = constrained(
          objective, made.damping, made.bounds.rows(active, Eigen::all), made.bounds.lower(active));
      const bool kept = (made.bounds.rows * z - made.bounds.lower).minCoeff() > -1e-9;
      if (kept && (best.size() == 0 || value(z) < value(best))) best = z;
    }
    REQUIRE(best.size() > 0);
    CHECK((made.bounds.rows * best - made.bounds.lower).minCoeff() < 1e-9);  // one is active
    const Eigen::VectorXd step = model_of(made).step({});
    CHECK((step - best).norm() < 1e-6 * best.norm());
  }
}

TEST_CASE("the gain of a new variable is what the objective falls by, all others refitted") {
  const Case made = random_case(9, 20, 3, 1e-2);
  const FullObjective objective(made);
  Eigen::VectorXd column = Numbers(10).matrix(60, 1);
  const auto gain_of = [&](const Eigen::VectorXd& rates) { return model_of(made).gain(rates); };
  if (gain_of(column).value == 0) column = -column;  // it would have to be negative
  const auto gain = gain_of(column);
  REQUIRE(gain.value > 0);
  // The same with the variable in the problem, without damping of its own.
  FullObjective larger = objective;
  larger.rows.conservativeResize(Eigen::NoChange, objective.rows.cols() + 1);
  larger.rows.rightCols(1).setZero();
  larger.rows.rightCols(1).topRows(60) = column / std::sqrt(20.0);
  Eigen::VectorXd damping = Eigen::VectorXd::Zero(made.damping.size() + 1);
  damping.head(made.damping.size()) = made.damping;
  const Eigen::MatrixXd none(0, damping.size());
  const Eigen::VectorXd with = constrained(larger, damping, none, Eigen::VectorXd(0));
  const Eigen::VectorXd without =
      constrained(objective, made.damping, none.leftCols(9), Eigen::VectorXd(0));
  const double before = objective(without) + made.damping.dot(without.cwiseAbs2());
  const double after = larger(with) + damping.dot(with.cwiseAbs2());
  CHECK(gain.value == Approx(before - after).epsilon(1e-9));
  CHECK(gain.at == Approx(with[with.size() - 1]).epsilon(1e-9));
  CHECK(gain_of(-column).value == 0);
}

TEST_CASE("the mismatch goes from the mean square to the largest distance") {
  Eigen::VectorXd residual(9);
  residual << 3, 0, 4, 0, 0, 1, 0, 2, 0;  // distances 5, 1, 2
  CHECK(elimination::mismatch(residual, {.unit = 1, .power = 2}) == Approx(30.0 / 3));
  CHECK(elimination::mismatch(residual, {.unit = 10, .power = 2}) == Approx(0.1));
  CHECK(elimination::mismatch(residual, {.unit = 1, .power = 400}) == Approx(25).epsilon(0.01));
  CHECK(elimination::mismatch(Eigen::VectorXd::Zero(9), {}) == 0);
}

TEST_CASE("for any power the model's gradient is that of the mismatch and the further squares") {
  const Case made = random_case(11, 15, 3, 1e-2);
  for (const double power : {2.0, 4.0, 8.0}) {
    const Norm norm{.unit = 0.7, .power = power};
    const auto objective = [&](const Eigen::VectorXd& z) {
      return elimination::mismatch(made.local.distance.residual + made.local.distance.jacobian * z,
                                   norm) +
             (made.further.value + made.further.rates * z).squaredNorm();
    };
    const Eigen::VectorXd gradient = model_of(made, norm).gradient();
    for (Eigen::Index i = 0; i < gradient.size(); ++i) {
      constexpr double h = 1e-6;
      const Eigen::VectorXd e = h * Eigen::VectorXd::Unit(gradient.size(), i);
      CHECK(gradient[i] == Approx((objective(e) - objective(-e)) / (2 * h)).epsilon(1e-5));
    }
  }
}
