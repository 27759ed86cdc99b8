// Steps of a network in equilibrium against what they claim.
#include "state/fitted_network.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <numeric>
#include <tencer/ground_structure/force_balance.hpp>

#include "fixtures/problems.hpp"
#include "moves/insertion.hpp"
#include "state/fit_problem.hpp"

using namespace tencer;
using elimination::FittedNetwork;
using elimination::Requirements;

namespace {

struct Balanced {
  ground_structure::Problem problem;
  network::Network network;
  double diagonal = 0.0;

  Requirements requirements() const {
    return {.target = problem.target, .rules = problem.rules, .min_eigenvalue = 100};
  }
  // In units of a tenth of a percent of the size.
  elimination::Objective objective(double power = 2.0, double stability_weight = 0.1) const {
    return {.norm = {.unit = 1e-3 * diagonal, .power = power},
            .stability_weight = stability_weight};
  }
};

// A network of some twenty cables that holds a trefoil.
const Balanced& balanced() {
  static const Balanced made = [] {
    Balanced result{.problem = fixtures::problem_of(fixtures::trefoil(48)), .network = {}};
    result.network =
        ground_structure::force_balance(result.problem, nullptr, {.max_error_percent = 0.5})
            .network;
    result.diagonal = model::diagonal(result.problem.target);
    return result;
  }();
  return made;
}

FittedNetwork fitted(const elimination::Objective& objective, const Requirements& requirements) {
  return {balanced().network, requirements, objective, {}, {}};
}

}  // namespace

TEST_CASE("a network is fitted step by step, and each step is an equilibrium that is closer") {
  const Requirements requirements = balanced().requirements();
  FittedNetwork network = fitted(balanced().objective(), requirements);
  REQUIRE(network.usable());
  const double before = network.value();
  network.refit(3);
  CHECK(network.value() < before);
  CHECK(network::fault_of(network.network()) == network::Fault::none);
  CHECK(sensitivity::deviation(balanced().problem.target, network.network().state).max_percent ==
        Approx(network.deviation().max_percent));
}

TEST_CASE("a step that is not accepted leaves the network as it is") {
  const Requirements requirements = balanced().requirements();
  FittedNetwork network = fitted(balanced().objective(), requirements);
  REQUIRE(network.usable());
  const auto model = network.gauss_newton_model();
  const double value = network.value();
  const Eigen::MatrixXd x = network.at().state[0].x;
  // No objective is below zero.
  CHECK_FALSE(network.move(model.local(), model.step({}), {}, 0.0));
  // A step that is not a number, or far too long.
  const Eigen::VectorXd nothing =
      Eigen::VectorXd::Constant(model.local().ties.cols(), std::nan(""));
  CHECK_FALSE(network.move(model.local(), nothing, {}, 1e9));
  CHECK_FALSE(network.move(model.local(), 1e4 * model.step({}), {}, 1e9));
  const Eigen::VectorXd endless = Eigen::VectorXd::Constant(nothing.size(), 1e200);
  CHECK_FALSE(network.move(model.local(), endless, {}, 1e9));
  CHECK(network.value() == value);
  CHECK(network.at().state[0].x == x);
  CHECK(network.usable());
}

TEST_CASE("the predicted cost of a removal is near that of the true refit") {
  const Requirements requirements = balanced().requirements();
  const auto objective = balanced().objective(2.0, 0.0);
  FittedNetwork network = fitted(objective, requirements);
  REQUIRE(network.usable());
  network.refit(12, 1e-3);
  const auto start = network.network();
  const Eigen::VectorXd costs = network.gauss_newton_model(1e-3).removal_costs();
  const auto model = network.gauss_newton_model(10);
  std::vector<int> order(static_cast<std::size_t>(costs.size()));
  std::iota(order.begin(), order.end(), 0);
  std::ranges::sort(order, {}, [&](int orbit) { return costs[orbit]; });
  // The cheapest may not stand without.
  const auto out = std::ranges::find_if(order, [&](int orbit) {
    return network.move(model.local(), model.step({orbit}), {orbit}, 1e9);
  });
  REQUIRE(out - order.begin() < 5);
  network.refit(12, 1e-3);
  // The prediction is of first order, and the refit is stopped early.
  CHECK(network.value() < 2 * costs[*out] + 0.01);
  CHECK(network.value() < 0.5 * costs[order.back()]);
  CHECK(network.cables() == static_cast<int>(start.structure.cables.size()) - 1);
}

TEST_CASE("the fit's gradient is that of its value by differences") {
  const Requirements requirements = balanced().requirements();
  for (const double power : {2.0, 8.0}) {
    FittedNetwork network = fitted(balanced().objective(power), requirements);
    REQUIRE(network.usable());
    elimination::FitProblem fit(network, 4.0);
    auto problem = fit.problem();
    // Off the start, so that attachments are off the vertices.
    Eigen::VectorXd p = fit.start();
    for (Eigen::Index i = 0; i < p.size(); ++i)
      p[i] = 1e-4 * std::sin(3.0 * static_cast<double>(i) + 1.0);
    REQUIRE(problem.value(p));
    Eigen::VectorXd gradient;
    REQUIRE(problem.gradient(p, gradient));
    constexpr double h = 1e-5;
    for (Eigen::Index i = 0; i < p.size(); i += 3) {
      const Eigen::VectorXd e = h * Eigen::VectorXd::Unit(p.size(), i);
      const auto above = problem.value(p + e);
      const auto below = problem.value(p - e);
      REQUIRE(above);
      REQUIRE(below);
      const double difference = (*above - *below) / (2 * h);
      CHECK(gradient[i] == Approx(difference).epsilon(1e-3).margin(1e-3 * gradient.norm()));
    }
  }
}

TEST_CASE("an outer fit leaves the network at the best that was evaluated") {
  const Requirements requirements = balanced().requirements();
  // Stability is worth nothing: it changes a little when cables become inextensible again.
  FittedNetwork network = fitted(balanced().objective(2.0, 0.0), requirements);
  REQUIRE(network.usable());
  elimination::FitProblem fit(network, 4.0);
  auto problem = fit.problem();
  const double before = problem.value(fit.start()).value();
  Eigen::VectorXd gradient;
  REQUIRE(problem.gradient(fit.start(), gradient));
  double best = before;
  for (double step = 1e-2; step > 1e-7; step /= 4) {
    const auto value = problem.value(-step * gradient / gradient.norm());
    if (value) best = std::min(best, *value);
  }
  REQUIRE(best < before);
  fit.finish();
  CHECK(network.usable());
  CHECK(network.value() == Approx(best).epsilon(1e-6));
}

TEST_CASE("a candidate's price is the slope of the distance in its tension") {
  const Requirements requirements = balanced().requirements();
  FittedNetwork network = fitted(balanced().objective(2.0, 0.0), requirements);
  REQUIRE(network.usable());
  const auto insertions =
      elimination::best_insertions(network, balanced().problem.candidates, 3, {});
  REQUIRE(insertions.size() == 3);
  for (const auto& insertion : insertions) {
    REQUIRE(insertion.cables.size() == 1);
    CHECK(insertion.tension > 0);
    // A little of the tension brings the network closer, as predicted.
    constexpr double part = 1e-3;
    FittedNetwork with(elimination::with_insertion(balanced().network, insertion, part),
                       requirements, balanced().objective(2.0, 0.0), {}, {});
    REQUIRE(with.usable());
    CHECK(with.value() < network.value());
  }
}

TEST_CASE(
    "a brace takes most of what errors do to the soft modes, or the compliance without errors") {
  const bool with_errors = GENERATE(true, false);
  Requirements requirements = balanced().requirements();
  if (with_errors) requirements.workmanship = {.length_error = 1e-4, .attachment_error = 2e-4};
  FittedNetwork network = fitted(balanced().objective(), requirements);
  REQUIRE(network.usable());
  const auto motion = [&](const FittedNetwork& of) {
    return with_errors ? of.errors().covariance.trace() : of.soft().values.cwiseInverse().sum();
  };
  const auto braces = elimination::best_braces(network, balanced().problem.candidates, 3, {});
  REQUIRE(braces.size() == 3);
  for (const auto& brace : braces) {
    CHECK(brace.tension > 0);
    FittedNetwork with(elimination::with_insertion(balanced().network, brace, 1.0), requirements,
                       balanced().objective(), {}, {});
    REQUIRE(with.usable());
    CHECK(motion(with) < motion(network));
  }
}
