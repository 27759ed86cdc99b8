// Equilibria and what is certified of them do not depend on where a structure is, on how it is
// numbered, or on units.
#include <tencer/equilibrium/inextensible.hpp>

#include "transforms.hpp"

using namespace tencer;
using namespace tencer::property;
using equilibrium::Equilibrium;
using equilibrium::System;

namespace {

struct Rest {
  Posed posed;
  double energy = 0.0;
  double eigenvalue = 0.0, built_eigenvalue = 0.0;  // with springs, with inextensible cables
  int slack = 0;
  Eigen::VectorXd tensions{};
};

Rest at_rest(const Posed& start) {
  const System system(start.structure);
  const Equilibrium found = equilibrium::solve(system, start.state());
  RC_ASSERT(found.usable());
  Rest result{.posed = start, .energy = found.energy};
  for (std::size_t r = 0; r < start.x.size(); ++r) result.posed.x[r] = found.state[r].x;
  result.eigenvalue = equilibrium::stability(system, found.state).smallest_eigenvalue;
  result.tensions = system.internal_forces(found.state).tension;
  const auto assessment = equilibrium::assess(start.structure, found.state, result.tensions);
  RC_ASSERT(assessment.certified());
  result.built_eigenvalue = assessment.stability.smallest_eigenvalue;
  result.slack = static_cast<int>(assessment.slack.size());
  return result;
}

// A little off the equilibrium.
Posed disturbed() {
  Posed a = held().posed;
  for (auto& x : a.x) x += vectors(x.cols(), 0.01);
  return a;
}

Eigen::MatrixXd distances(const Posed& a) {
  Eigen::Index vertices = 0;
  for (const auto& x : a.x) vertices += x.cols();
  Eigen::Matrix3Xd all(3, vertices);
  vertices = 0;
  for (const auto& x : a.x) {
    all.middleCols(vertices, x.cols()) = x;
    vertices += x.cols();
  }
  Eigen::MatrixXd result(vertices, vertices);
  for (Eigen::Index i = 0; i < vertices; ++i)
    result.col(i) = (all.colwise() - all.col(i)).colwise().norm();
  return result;
}

// `same`: a's equilibrium numbered as b's and in its units. Digits: what the solver's tolerance,
// 1e-10 of the forces, leaves of a shape with eigenvalues above 50.
void check_same(const Rest& same, const Rest& b, const Units& units = {}) {
  const double energy = units.force() * units.length;
  RC_ASSERT(std::abs(same.energy * energy - b.energy) <= 1e-9 * b.energy);
  RC_ASSERT(largest(distances(same.posed) - distances(b.posed)) <= 1e-6 * units.length);
  RC_ASSERT(std::abs(same.eigenvalue - b.eigenvalue) <= 1e-5 * b.eigenvalue);
  RC_ASSERT(std::abs(same.built_eigenvalue - b.built_eigenvalue) <= 1e-5 * b.built_eigenvalue);
  RC_ASSERT(same.slack == b.slack);
}

}  // namespace

TEST_CASE("equilibrium and certificate are the same after") {
  rc::prop("rigid motion", [] {
    const Posed a = disturbed();
    check_same(at_rest(a), at_rest(moved(a, motion())));
  });
  rc::prop("numbering from another vertex, the other end, in another order", [] {
    const Posed a = disturbed();
    const Rest rest = at_rest(a);
    // What is done to the start is done to the result by the same numbers.
    const auto order = order_of_rods(a);
    const Posed b = listed(reversed(a), order);
    Rest same = rest;
    same.posed = listed(reversed(rest.posed), order);
    check_same(same, at_rest(b));
    const Rest elsewhere = at_rest(started_elsewhere(a));
    RC_ASSERT(std::abs(elsewhere.energy - rest.energy) <= 1e-9 * rest.energy);
    RC_ASSERT(largest(elsewhere.tensions - rest.tensions) <= 1e-7 * largest(rest.tensions));
    RC_ASSERT(std::abs(elsewhere.eigenvalue - rest.eigenvalue) <= 1e-5 * rest.eigenvalue);
  });
  rc::prop("a change of units", [] {
    const Posed a = disturbed();
    const Units units{.length = std::pow(10, number(-6, 6)),
                      .modulus = std::pow(10, number(-6, 12))};
    Rest same = at_rest(a);
    for (auto& x : same.posed.x) x *= units.length;
    check_same(same, at_rest(in_units(a, units)), units);
  });
}
