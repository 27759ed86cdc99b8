#include <catch2/catch.hpp>
#include <tencer/equilibrium/built.hpp>
#include <tencer/sparsify/search.hpp>
#include <tencer/symmetry/orbit.hpp>
#include <tencer/symmetry/subgroups.hpp>

#include "models.hpp"

using namespace tencer;
using namespace tencer::sparsify;
using namespace tencer::sparsify::test;

namespace {

struct Task {
  Network bare{};
  sensitivity::Target target{};
  std::vector<springs::Cable> candidates{};
  symmetry::Group group{};
};

Task task_of(const Model& model, const Rules& rules = {}) {
  return {.bare = {model.structure, equilibrium::make_state(model.structure, model.positions)},
          .target = {.points = model.positions},
          .candidates = candidates(model.structure, model.positions, rules).value(),
          .group = group_of(model)};
}

ThinResult searched(const Task& task, const ThinOptions& options,
                    const symmetry::Group* symmetry = nullptr,
                    std::span<const symmetry::Group> hints = {}, const Control& control = {}) {
  return search(task.bare, task.target, {}, task.candidates, symmetry, hints, options, control);
}

double error(const Task& task, const ThinResult& result) {
  return sensitivity::deviation(task.target, result.stage.network.state).max_percent;
}

}  // namespace

TEST_CASE("A search ends on the rods as they are, within the tolerance") {
  for (const int vertices : {60, 120}) {  // the second is searched on fewer vertices
    CAPTURE(vertices);
    const Task task = task_of(trefoil(vertices));
    const ThinResult result = searched(task, {.max_percent = 1.0});
    CHECK(result.stage.sound);
    CHECK(result.stage.network.state[0].x.cols() == vertices);
    CHECK(error(task, result) <= 1.0);
    CHECK(cables(result.stage.network) <= 10);
    const bool fewer = result.stage.trace.front().note.find("vertices") != std::string::npos;
    CHECK(fewer == (vertices == 120));
    for (const auto& choice : result.choices) CHECK(choice.network.state[0].x.cols() == vertices);
  }
}

TEST_CASE("Every number of cables on the way is carried over") {
  const Task task = task_of(trefoil(120));
  const ThinResult result = searched(task, {.max_percent = 1.0, .every_number = true});
  CHECK(result.stage.sound);
  REQUIRE(result.choices.size() > 4);
  for (std::size_t i = 1; i < result.choices.size(); ++i)
    CHECK(result.choices[i].max_percent < result.choices[i - 1].max_percent);
}

TEST_CASE("A search keeps the symmetry it is given, on few vertices and on all") {
  const Task task = task_of(trefoil(120));
  REQUIRE(task.group.order() == 6);
  const ThinResult result = searched(task, {.max_percent = 1.0}, &task.group);
  CHECK(result.stage.sound);
  const auto& found = result.stage.network.structure.cables;
  CHECK(symmetry::complete(found, task.group, 1e-3).size() == found.size());
}

TEST_CASE("Hints are tried besides, and bind nobody") {
  const Task task = task_of(trefoil(60));
  const auto hints = symmetry::subgroups(task.group, 12);
  const ThinResult with = searched(task, {.cables = 9}, nullptr, hints);
  const ThinResult without = searched(task, {.cables = 9});
  CHECK(with.stage.sound);
  CHECK(cables(with.stage.network) <= 9);
  // The first descents are the same; what comes after may lead elsewhere, but not far.
  CHECK(error(task, with) < 1.5 * error(task, without));
}

TEST_CASE("What is said to settle from the target does, with inextensible cables") {
  const Task task = task_of(trefoil(60));
  const auto hints = symmetry::subgroups(task.group, 12);
  const ThinResult result = searched(task, {.max_percent = 1.0}, nullptr, hints);
  int settling = 0;
  for (const Choice& choice : result.choices) {
    if (!choice.settles) continue;
    ++settling;
    equilibrium::Structure built = choice.network.structure;
    const Eigen::VectorXd lengths = cable_lengths(choice.network);
    for (Eigen::Index c = 0; c < lengths.size(); ++c) built.cables[c].rest_length = lengths[c];
    const auto form = equilibrium::settle(built, task.bare.state);
    REQUIRE(form.equilibrium.usable());
    const sensitivity::Target pose{.points = {choice.network.state[0].x}};
    CHECK(sensitivity::deviation(pose, form.equilibrium.state).max_percent < 0.02);
  }
  CHECK(settling > 0);
}

TEST_CASE("A rod that needs no cables is tied to the one that does") {
  // An ellipse must be held, a circle within it need not be.
  Eigen::Matrix3Xd ellipse = curves::circle(1.0, 40).points;
  ellipse.row(0) *= 1.5;
  const Task task =
      task_of(make_model({{.points = ellipse, .closed = true}, curves::circle(0.5, 40)}));
  const ThinResult result = searched(task, {.max_percent = 2.0});
  CHECK(result.stage.sound);
  const equilibrium::System system(result.stage.network.structure);
  CHECK(equilibrium::free_groups(equilibrium::rigid_modes(system, result.stage.network.state)) ==
        1);
}

TEST_CASE("A search that is stopped gives what it has") {
  const Task task = task_of(trefoil(120));
  std::stop_source source;
  int reports = 0;
  const Control control{.stop = source.get_token(), .progress = [&](const Progress&) {
                          if (++reports == 40) source.request_stop();
                        }};
  const ThinResult result = searched(task, {.max_percent = 1.0}, nullptr, {}, control);
  CHECK(result.stage.interrupted);
  CHECK(result.stage.network.state[0].x.cols() == 120);
}

TEST_CASE("Rods that hold their shape by themselves get no cables") {
  for (const int vertices : {40, 80}) {
    const Task task = task_of(make_model({curves::circle(1.0, vertices)}));
    const ThinResult result = searched(task, {.max_percent = 1.0});
    CHECK(result.stage.sound);
    CHECK(cables(result.stage.network) == 0);
    CHECK(error(task, result) < 1e-6);
  }
}

TEST_CASE("Many rods are searched part by part, and end tied, stable and within the tolerance") {
  std::vector<geometry::Polyline> links;
  for (int r = 0; r < 4; ++r) {
    geometry::Polyline link = curves::ellipse(1.3, 1.0, 24);
    if (r % 2 == 1) link.points.row(1).swap(link.points.row(2));
    link.points.row(0).array() += 1.8 * r;
    links.push_back(std::move(link));
  }
  const Task task = task_of(make_model(links));
  for (const ThinOptions& options : {ThinOptions{.max_percent = 1.0}, ThinOptions{.cables = 24}}) {
    const ThinResult result = searched(task, options);
    CHECK(result.stage.sound);
    const Network& found = result.stage.network;
    if (options.cables > 0)
      CHECK(cables(found) <= options.cables);
    else
      CHECK(cables(found) <= 24);
    CHECK(error(task, result) <= 1.0);
    const equilibrium::System system(found.structure);
    CHECK(equilibrium::free_groups(equilibrium::rigid_modes(system, found.state)) == 1);
    CHECK(equilibrium::solve(system, found.state).usable());
  }
}
