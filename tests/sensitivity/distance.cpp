#include <Eigen/Geometry>
#include <catch2/catch.hpp>

#include "fixtures.hpp"

namespace tencer::sensitivity {
namespace {

model::State state_of(const Example& e) { return model::make_state(e.structure, e.start); }

}  // namespace

TEST_CASE("a deviation is measured vertex by vertex") {
  Example e = open_rod();
  e.target.align = false;
  e.target.points = e.start;
  e.target.points[0].col(3) += Eigen::Vector3d(0.3, 0, 0.4);
  e.target.points[0].col(7) += Eigen::Vector3d(0, 0.2, 0);
  e.target.weights = {Eigen::VectorXd::Constant(20, 0.5)};
  const Eigen::Matrix3Xd& points = e.target.points[0];
  const double diagonal = (points.rowwise().maxCoeff() - points.rowwise().minCoeff()).norm();

  Deviation d = deviation(e.target, state_of(e));
  CHECK(d.value == Approx(0.5 * (0.25 + 0.04)));
  CHECK(d.max == Approx(0.5));
  CHECK(d.rms == Approx(std::sqrt((0.25 + 0.04) / 20)));
  CHECK(d.max_percent == Approx(50 / diagonal));
  CHECK(d.rms_percent == Approx(100 * d.rms / diagonal));

  e.target.weights[0][3] = 0;
  d = deviation(e.target, state_of(e));
  CHECK(d.max == Approx(0.2));
  CHECK(d.rms == Approx(std::sqrt(0.04 / 19)));
}

TEST_CASE("a moved target is found again") {
  for (Example e : {open_rod(), two_rods(), planar_rod()}) {
    INFO(e.name);
    registration::RigidMotion motion;
    motion.rotation = Eigen::AngleAxisd(2.2, Eigen::Vector3d::UnitZ()).toRotationMatrix();
    motion.translation = {2, -3, 0};
    e.target.points = e.start;
    for (auto& points : e.target.points) points = motion.apply(points);
    const Deviation d = deviation(e.target, state_of(e));
    CHECK(d.max < 1e-14);
    CHECK((d.motion.rotation * motion.rotation).isIdentity(1e-14));
    e.target.align = false;
    CHECK(deviation(e.target, state_of(e)).max > 1);
  }
}

TEST_CASE("in the plane a target is turned but not flipped over") {
  Example e = planar_rod();
  e.target.points = nearby(e.start);
  e.target.points[0].row(2).setZero();
  e.start = e.target.points;
  e.target.points[0].row(0) *= -1;
  CHECK(deviation(e.target, state_of(e)).max > 0.01);
  e.target.planar = false;
  CHECK(deviation(e.target, state_of(e)).max < 1e-14);
}

TEST_CASE("the distance's derivatives agree with differences, however far the target") {
  for (const Example& e : examples()) {
    INFO(e.name);
    const equilibrium::System system(e.structure);
    // Far off, so that what the alignment takes up matters.
    model::State state = state_of(e);
    for (auto& rod : state)
      for (Eigen::Index i = 0; i < rod.x.cols(); ++i)
        for (const int axis : {0, 1})
          rod.x(axis, i) += 0.5 * std::sin(static_cast<double>(axis + 2 * i));
    const Distance distance(e.target, system, state);
    CHECK(distance.residual().squaredNorm() == Approx(distance.deviation().value));
    Eigen::VectorXd v = Eigen::VectorXd::LinSpaced(system.size(), -1, 1).array().sin();
    const auto moved = [&](double h) {
      return Distance(e.target, system, system.displaced(state, h * v));
    };
    constexpr double h = 1e-5;
    const double slope = (moved(h).deviation().value - moved(-h).deviation().value) / (2 * h);
    CHECK(distance.gradient().dot(v) == Approx(slope).epsilon(1e-7));
    const Eigen::VectorXd change = (moved(h).gradient() - moved(-h).gradient()) / (2 * h);
    CHECK((distance.hessian_times(v) - change).norm() < 1e-6 * change.norm());
    CHECK(2 * distance.residual_rates(v).col(0).dot(distance.residual()) ==
          Approx(distance.gradient().dot(v)).epsilon(1e-11));
  }
}

TEST_CASE("the residual does not see rigid motions") {
  for (const Example& e : {closed_rod(1e3), two_rods(), planar_rod()}) {
    INFO(e.name);
    model::Target target = e.target;
    target.points = e.start;
    const equilibrium::System system(e.structure);
    const model::State state = state_of(e);
    const Distance distance(target, system, state);
    for (const auto& modes : equilibrium::rigid_modes(system, state)) {
      REQUIRE(modes.basis.cols() == (e.structure.planar ? 3 : 6));
      CHECK(distance.residual_rates(modes.basis).norm() < 1e-13);
      CHECK(distance.hessian_times(modes.basis).norm() < 1e-13);
    }
  }
}

TEST_CASE("what lies along the view does not count") {
  Example e = two_rods();
  e.target.points = e.start;
  const Eigen::Vector3d along = Eigen::Vector3d(0.4, -0.2, 1).normalized();
  e.target.views = {{.direction = 3 * along}};
  model::State state = state_of(e);
  for (auto& rod : state)
    for (Eigen::Index i = 0; i < rod.x.cols(); ++i)
      rod.x.col(i) += 0.3 * std::sin(static_cast<double>(i)) * along;
  CHECK(deviation(e.target, state).max < 1e-12);
  // Of what lies across it the same is seen, aligned or held.
  const Eigen::Vector3d off = 0.02 * along.unitOrthogonal();
  state[0].x.col(3) += off;
  e.target.align = false;
  CHECK(deviation(e.target, state).max == Approx(0.02));
  CHECK(deviation(e.target, state).value == Approx(0.0004));
  e.target.align = true;
  CHECK(deviation(e.target, state).value < 0.0004);
  // Half of what two views see is across each of them.
  e.target.align = false;
  e.target.points = e.start;
  e.target.views = {{.direction = {1, 0, 0}}, {.direction = {0, 1, 0}}};
  state = state_of(e);
  state[0].x(0, 3) += 0.02;
  CHECK(deviation(e.target, state).max == Approx(0.02 * std::sqrt(0.5)));
}

TEST_CASE("turning the structure changes nothing that is seen of it") {
  const Eigen::Matrix3d turn =
      Eigen::AngleAxisd(2.2, Eigen::Vector3d(1, 0.3, -0.4).normalized()).toRotationMatrix();
  for (const Example& e : examples()) {
    if (e.target.views.empty() || !e.target.align) continue;
    INFO(e.name);
    const model::State state = state_of(e);
    model::State moved = state;
    for (auto& rod : moved) rod.x = turn * rod.x;
    const Deviation before = deviation(e.target, state);
    CHECK(deviation(e.target, moved).value == Approx(before.value).epsilon(1e-11));
    CHECK(deviation(e.target, moved).max == Approx(before.max).epsilon(1e-9));
    model::Target target = e.target;
    for (auto& points : target.points) points = turn * points;
    target.views = turned(target.views, turn);
    CHECK(deviation(target, state).value == Approx(before.value).epsilon(1e-11));
    CHECK(deviation(target, state).max == Approx(before.max).epsilon(1e-9));
  }
}

}  // namespace tencer::sensitivity
