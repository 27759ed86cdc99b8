// The response against settling anew, and draws against what can be worked out by hand.
#include <catch2/catch.hpp>
#include <cmath>
#include <tencer/certify/tolerance.hpp>
#include <tencer/equilibrium/inextensible.hpp>
#include <tencer/sensitivity/distance.hpp>
#include <tencer/sensitivity/parameters.hpp>

#include "fixtures/bow.hpp"

using namespace tencer;
using Catch::Matchers::WithinRel;
using springs::ParameterKind;

namespace {

equilibrium::InextensibleEquilibrium settled(const fixtures::Held& held,
                                             const springs::Parameter& parameter, double error) {
  model::Structure structure = held.structure;
  Eigen::VectorXd value = sensitivity::values(structure.cables, {&parameter, 1});
  value[0] += error;
  structure.cables = sensitivity::with_values(structure.cables, {&parameter, 1}, value);
  auto found = equilibrium::relax_inextensible(structure, held.state);
  REQUIRE(found.equilibrium.usable());
  return found;
}

// Two bows, each clamped at one end, with a cable from the other end to an anchor.
fixtures::Held two_bows() {
  constexpr int edges = 30;
  model::Structure structure;
  structure.planar = true;
  structure.anchors.resize(3, 2);
  structure.anchors << 0.3, 0.3, 0.8, 3.8, 0, 0;
  std::vector<Eigen::Matrix3Xd> x;
  for (const int r : {0, 1}) {
    structure.rods.push_back(fixtures::slender_rod(edges, 1.0));
    structure.pins.push_back({.rod = r, .vertex = 0});
    structure.pins.push_back({.rod = r, .vertex = 1});
    structure.cables.push_back(
        {.a = springs::AtAnchor{r}, .b = springs::OnRod{r, 1.0}, .rest_length = 0.7});
    x.push_back(fixtures::straight(edges + 1, 1.0));
    x.back().row(1).array() += 3.0 * r;
  }
  auto found = equilibrium::relax_inextensible(structure, model::make_state(structure, x));
  REQUIRE(found.equilibrium.usable());
  return {std::move(structure), std::move(found.equilibrium.state), std::move(found.tensions)};
}

}  // namespace

TEST_CASE("the response is that of settling anew with another length or attachment") {
  const fixtures::Held bow = fixtures::bow();
  REQUIRE(bow.tensions.minCoeff() > 1);
  const auto response = certify::pose_response(bow.structure, bow.state, bow.tensions);
  REQUIRE(response.computed);
  REQUIRE(response.parameters.size() == 6);
  const equilibrium::System system(bow.structure);
  const sensitivity::Distance pose(model::make_target(bow.structure, {bow.state[0].x}), system,
                                   bow.state);
  constexpr double step = 3e-4;
  for (std::size_t p = 0; p < response.parameters.size(); ++p) {
    const auto more = settled(bow, response.parameters[p], step);
    const auto less = settled(bow, response.parameters[p], -step);
    Eigen::VectorXd rate = Eigen::VectorXd::Zero(system.size());
    for (int v = 0; v < bow.state[0].x.cols(); ++v)
      for (int axis = 0; axis < 2; ++axis)
        rate[system.position_index(0, v, axis)] =
            (more.equilibrium.state[0].x(axis, v) - less.equilibrium.state[0].x(axis, v)) /
            (2 * step);
    const Eigen::VectorXd expected = pose.residual_rates(rate);
    const auto column = static_cast<Eigen::Index>(p);
    CAPTURE(p, expected.norm());
    CHECK((response.displacement.col(column) - expected).norm() < 5e-4 * expected.norm());
    const Eigen::VectorXd pull = (more.tensions - less.tensions) / (2 * step);
    CHECK((response.tension.col(column) - pull).norm() < 5e-4 * pull.norm());
  }
}

TEST_CASE("of errors that a view does not see nothing is told") {
  fixtures::Held bow = fixtures::bow();
  bow.structure.planar = false;
  const auto all = certify::pose_response(bow.structure, bow.state, bow.tensions);
  REQUIRE(all.computed);
  const auto along = [&](const Eigen::Vector3d& direction) {
    const auto seen =
        certify::pose_response(bow.structure, bow.state, bow.tensions, {{.direction = direction}});
    REQUIRE(seen.computed);
    return certify::typical_deviation(seen, {.length = 0.01, .attachment = 0.01});
  };
  const double whole = certify::typical_deviation(all, {.length = 0.01, .attachment = 0.01});
  CHECK(along({1, 0, 0}) < whole);
  CHECK(along({1, 0, 0}) > 0);
}

TEST_CASE("a slack cable's errors do nothing, and it has no parameters") {
  fixtures::Held bow = fixtures::bow();
  const auto before = certify::pose_response(bow.structure, bow.state, bow.tensions);
  bow.structure.cables.insert(
      bow.structure.cables.begin(),
      {.a = springs::OnRod{0, 0.1}, .b = springs::OnRod{0, 0.9}, .rest_length = 2.0});
  Eigen::VectorXd tensions(3);
  tensions << 0, bow.tensions;
  const auto after = certify::pose_response(bow.structure, bow.state, tensions);
  REQUIRE(after.parameters.size() == before.parameters.size());
  CHECK(after.parameters.front().cable == 1);
  CHECK((after.displacement - before.displacement).norm() < 1e-9 * before.displacement.norm());
  CHECK(after.tension.row(0).norm() == 0);
  CHECK((after.tension.bottomRows(2) - before.tension).norm() < 1e-9 * before.tension.norm());
}

TEST_CASE("draws of two equal bows deviate as the larger of two uniform errors") {
  const fixtures::Held bows = two_bows();
  const auto response = certify::pose_response(bows.structure, bows.state, bows.tensions);
  REQUIRE(response.parameters.size() == 4);  // two lengths, two attachments
  constexpr double error = 1e-3;
  const double each = error * response.displacement.col(0)
                                  .reshaped(3, response.displacement.rows() / 3)
                                  .colwise()
                                  .norm()
                                  .maxCoeff();
  const certify::CableErrors lengths{.length = error};
  const auto found = certify::tolerance(response, bows.tensions, lengths, 40000, 7);
  CHECK_THAT(found.expected, WithinRel(2.0 / 3 * each, 0.01));
  CHECK_THAT(found.percentile_95, WithinRel(std::sqrt(0.95) * each, 0.01));
  CHECK_THAT(found.worst, WithinRel(each, 1e-3));
  CHECK(found.worst <= each);
  CHECK_THAT(found.decisive, WithinRel(each / std::sqrt(3.0), 1e-6));
  CHECK_THAT(certify::typical_deviation(response, lengths), WithinRel(each / std::sqrt(3.0), 1e-6));
  // All are alike: a cable goes slack when its own error has undone its tension.
  CHECK_THAT(found.slack_at,
             WithinRel(bows.tensions[0] / (error * std::abs(response.tension(0, 0))), 1e-6));
  CHECK_THAT(response.displacement.col(0).norm(),
             WithinRel(response.displacement.col(2).norm(), 1e-6));

  const auto again = certify::tolerance(response, bows.tensions, lengths, 40000, 7);
  CHECK(again.worst == found.worst);
  CHECK(certify::tolerance(response, bows.tensions, lengths, 40000, 8).worst != found.worst);
}

TEST_CASE("without errors or cables nothing deviates") {
  const fixtures::Held bow = fixtures::bow();
  const auto response = certify::pose_response(bow.structure, bow.state, bow.tensions);
  const auto exact = certify::tolerance(response, bow.tensions, {});
  CHECK(exact.worst == 0);
  CHECK(exact.decisive_cable == -1);
  CHECK(exact.first_slack == -1);
  CHECK_THROWS_AS(certify::tolerance(response, bow.tensions, {.length = -1}),
                  std::invalid_argument);

  model::Structure bare;
  bare.rods = {fixtures::slender_rod(10, 1.0)};
  const auto alone = certify::pose_response(
      bare, model::make_state(bare, {fixtures::straight(11, 1.0)}), Eigen::VectorXd(0));
  REQUIRE(alone.computed);
  CHECK(certify::tolerance(alone, Eigen::VectorXd(0), {.length = 1}).worst == 0);
}

TEST_CASE("draws are uniform in [-1, 1] and belong to their seed") {
  const Eigen::MatrixXd draws = certify::unit_draws(3, 20000, 1);
  CHECK(draws.maxCoeff() <= 1);
  CHECK(draws.minCoeff() >= -1);
  CHECK(std::abs(draws.mean()) < 0.01);
  CHECK_THAT(draws.squaredNorm() / static_cast<double>(draws.size()), WithinRel(1.0 / 3, 0.02));
  CHECK(draws == certify::unit_draws(3, 20000, 1));
  CHECK(draws != certify::unit_draws(3, 20000, 2));
}
