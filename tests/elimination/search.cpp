#include <catch2/catch.hpp>
#include <tencer/elimination/search.hpp>
#include <tencer/equilibrium/inextensible.hpp>
#include <tencer/symmetry/orbit.hpp>

#include "fixtures/problems.hpp"

using namespace tencer;
using namespace tencer::fixtures;
using elimination::EliminationOptions;
using elimination::EliminationResult;
using elimination::search;
using ground_structure::Problem;
using network::Network;

namespace {

// Without symmetric starts, which take as long as the rest, with few eliminations and one round of
// variations.
EliminationOptions quick(const model::Goal& goal) {
  EliminationOptions options{
      .goal = goal, .local_search = {.max_rounds = 1}, .start = {.max_seed_order = 0}};
  for (auto& balance : options.start.balances) balance.descents = 1;
  return options;
}

EliminationOptions within(double percent) { return quick({.max_error_percent = percent}); }

double error(const Problem& problem, const EliminationResult& result) {
  return sensitivity::deviation(problem.target, result.stage.network.state).max_percent;
}

}  // namespace

TEST_CASE("A search ends on the rods as they are, within the tolerance") {
  for (const int vertices : {60, 120}) {  // the second is searched on fewer vertices
    CAPTURE(vertices);
    const Problem problem = problem_of(trefoil(vertices));
    const EliminationResult result = search(problem, within(1.0));
    CHECK(result.stage.valid());
    CHECK(result.stage.network.state[0].x.cols() == vertices);
    CHECK(error(problem, result) <= 1.0);
    CHECK(cable_count(result.stage.network) <= 10);
    const bool fewer = result.stage.trace.front().note.find("vertices") != std::string::npos;
    CHECK(fewer == (vertices == 120));
    for (const auto& solution : result.solutions)
      CHECK(solution.network.state[0].x.cols() == vertices);
  }
}

TEST_CASE("Every number of cables on the way is carried over") {
  const Problem problem = problem_of(trefoil(120));
  const EliminationResult result =
      search(problem, quick({.max_error_percent = 1.0, .every_number = true}));
  CHECK(result.stage.valid());
  REQUIRE(result.solutions.size() > 4);
  for (std::size_t i = 1; i < result.solutions.size(); ++i)
    CHECK(result.solutions[i].max_percent < result.solutions[i - 1].max_percent);
}

TEST_CASE("A search keeps the symmetry it is given, on few vertices and on all") {
  const Model model = trefoil(120);
  Problem problem = problem_of(model);
  problem.symmetry = group_of(model);
  REQUIRE(problem.symmetry->order() == 6);
  const EliminationResult result = search(problem, within(1.0));
  CHECK(result.stage.valid());
  const auto& found = result.stage.network.structure.cables;
  CHECK(symmetry::complete(found, *problem.symmetry, 1e-3).size() == found.size());
}

TEST_CASE("Symmetry seeds are tried besides, and bind nobody") {
  const Problem problem = problem_of(trefoil(60));
  EliminationOptions options = quick({.cables = 9});
  const EliminationResult without = search(problem, options);
  options.start.max_seed_order = elimination::StartOptions{}.max_seed_order;
  const EliminationResult with = search(problem, options);
  CHECK(with.stage.valid());
  CHECK(cable_count(with.stage.network) <= 9);
  // The first eliminations are the same; what comes after may lead elsewhere, but not far.
  CHECK(error(problem, with) < 1.5 * error(problem, without));
}

TEST_CASE("What is said to settle from the target does, with inextensible cables") {
  const Problem problem = problem_of(trefoil(60));
  const EliminationResult result = search(problem, within(1.0));
  int settling = 0;
  for (const elimination::Solution& solution : result.solutions) {
    if (solution.standing.footing == model::Footing::none) continue;
    ++settling;
    model::Structure built = solution.network.structure;
    const Eigen::VectorXd lengths = cable_lengths(solution.network);
    for (Eigen::Index c = 0; c < lengths.size(); ++c) built.cables[c].rest_length = lengths[c];
    const auto form = equilibrium::relax_inextensible(built, problem.start);
    REQUIRE(form.equilibrium.usable());
    const model::Target pose{.points = {solution.network.state[0].x}};
    CHECK(sensitivity::deviation(pose, form.equilibrium.state).max_percent < 0.02);
  }
  CHECK(settling > 0);
}

TEST_CASE("A rod that needs no cables is tied to the one that does") {
  // An ellipse must be held, a circle within it need not be.
  Eigen::Matrix3Xd ellipse = curves::circle(1.0, 40).points;
  ellipse.row(0) *= 1.5;
  const Problem problem =
      problem_of(make_model({{.points = ellipse, .closed = true}, curves::circle(0.5, 40)}));
  const EliminationResult result = search(problem, within(2.0));
  CHECK(result.stage.valid());
  const equilibrium::System system(result.stage.network.structure);
  CHECK(equilibrium::floating_components(
            equilibrium::rigid_modes(system, result.stage.network.state)) == 1);
}

TEST_CASE("A search that is stopped gives what it has") {
  const Problem problem = problem_of(trefoil(120));
  std::stop_source source;
  int reports = 0;
  const network::Control control{.stop = source.get_token(),
                                 .progress = [&](const network::Progress&) {
                                   if (++reports == 40) source.request_stop();
                                 }};
  const EliminationResult result = search(problem, within(1.0), control);
  CHECK(result.stage.interrupted);
  CHECK(result.stage.network.state[0].x.cols() == 120);
}

TEST_CASE("Nothing stands that errors move further than is allowed, though all networks do") {
  const Problem problem = problem_of(trefoil(60));
  EliminationOptions options = within(1.0);
  options.local_search.max_rounds = 0;
  options.workmanship.length_error = 1e-4 * model::diagonal(problem.target);
  options.workmanship.max_deviation = 0.1 * options.workmanship.length_error;
  const EliminationResult result = search(problem, options);
  CHECK(result.stage.valid());
  REQUIRE(!result.solutions.empty());
  for (const auto& solution : result.solutions) CHECK(!solution.standing.stands());
}

TEST_CASE("Rods that hold their shape by themselves get no cables") {
  for (const int vertices : {40, 80}) {
    const Problem problem = problem_of(make_model({curves::circle(1.0, vertices)}));
    const EliminationResult result = search(problem, within(1.0));
    CHECK(result.stage.valid());
    CHECK(cable_count(result.stage.network) == 0);
    CHECK(error(problem, result) < 1e-6);
  }
}

TEST_CASE("Many rods are searched block by block, and end tied, stable and within the tolerance") {
  std::vector<geometry::Polyline> links;
  for (int r = 0; r < 4; ++r) {
    geometry::Polyline link = curves::ellipse(1.3, 1.0, 24);
    if (r % 2 == 1) link.points.row(1).swap(link.points.row(2));
    link.points.row(0).array() += 1.8 * r;
    links.push_back(std::move(link));
  }
  const Problem problem = problem_of(make_model(links));
  for (const EliminationOptions& options : {within(1.0), quick({.cables = 24})}) {
    const EliminationResult result = search(problem, options);
    CHECK(result.stage.valid());
    const Network& found = result.stage.network;
    if (options.goal.cables > 0)
      CHECK(cable_count(found) <= options.goal.cables);
    else
      CHECK(cable_count(found) <= 24);
    CHECK(error(problem, result) <= 1.0);
    const equilibrium::System system(found.structure);
    CHECK(equilibrium::floating_components(equilibrium::rigid_modes(system, found.state)) == 1);
    CHECK(equilibrium::solve(system, found.state).usable());
  }
}
