// How gaps change with the variables of a step, against differences.
#include "model/gap_bounds.hpp"

#include <catch2/catch.hpp>

#include "fixtures/networks.hpp"

using namespace tencer;
using namespace tencer::fixtures;
using namespace tencer::elimination;

namespace {

sensitivity::Configuration solved(const model::Structure& structure, const model::State& start) {
  sensitivity::Configuration at{.system = equilibrium::System(structure)};
  at.linearisation.matrix = at.system.pattern();
  at.state = equilibrium::solve(at.system, start, {.tolerance = 1e-13}, at.linearisation).state;
  return at;
}

Eigen::Vector3d place(const model::Structure& structure, const model::State& state,
                      const springs::End& end) {
  const auto& on = std::get<springs::OnRod>(end);
  const auto [edge, t] = model::arc_lengths(structure)[on.rod].locate(on.s);
  const auto& x = state[on.rod].x;
  return (1 - t) * x.col(edge) + t * x.col((edge + 1) % x.cols());
}

// Wide enough for some cables to be too near, and for bounds on many more.
constexpr double wide = 0.02;

}  // namespace

TEST_CASE("Bounds on gaps are first-order in the variables") {
  const Model model = trefoil(40);
  network::Network network = greedy_network(model, 10.0);
  for (auto& cable : network.structure.cables) {
    std::get<springs::OnRod>(cable.a).s += 0.4 / 40;
    std::get<springs::OnRod>(cable.b).s += 0.3 / 40;
  }
  const model::Gaps gaps{.clearance = wide, .mark_distance = 0.0};
  const auto at = solved(network.structure, network.state);
  const LocalModel local = local_model(at, target_of(model, network), nullptr);
  const StepBounds bounds = gap_bounds(at, local, gaps);
  REQUIRE(bounds.lower.size() > 5);

  // The bounds list passes cable by cable, in the finder's order; what is missing to each is the
  // lower bound unless that is cut to a radius.
  const auto gaps_of = [&](const model::Structure& structure, const model::State& state) {
    const model::CablePasses passes(structure, state, gaps);
    std::vector<double> distances;
    for (const auto& cable : structure.cables)
      for (const auto& pass : passes.of(cable, 0, 3.0)) {
        // Without what the chain of vertices cuts off, which bounds take as it is.
        const auto& x = state[pass.rod].x;
        const Eigen::Vector3d on_rod =
            (1 - pass.t) * x.col(pass.edge) + pass.t * x.col((pass.edge + 1) % x.cols());
        const Eigen::Vector3d on_cable = (1 - pass.u) * place(structure, state, cable.a) +
                                         pass.u * place(structure, state, cable.b);
        distances.push_back((on_cable - on_rod).norm());
      }
    return Eigen::VectorXd(
        Eigen::Map<Eigen::VectorXd>(distances.data(), static_cast<Eigen::Index>(distances.size())));
  };
  const auto moved = [&](Eigen::Index z, double by) {
    auto values = sensitivity::values(network.structure.cables, local.parameters);
    values[z] += by;
    model::Structure structure = network.structure;
    structure.cables = sensitivity::with_values(network.structure.cables, local.parameters, values);
    return gaps_of(structure, solved(structure, at.state).state);
  };
  const double step = 1e-6;
  for (const Eigen::Index z : {0, 1, 5, 12}) {
    const Eigen::VectorXd up = moved(z, step);
    const Eigen::VectorXd down = moved(z, -step);
    REQUIRE(up.size() == down.size());
    const Eigen::VectorXd rates = (up - down) / (2 * step);
    REQUIRE(rates.size() <= bounds.rows.rows());
    const Eigen::VectorXd claimed = bounds.rows.col(z).head(rates.size());
    // A nearest place that jumps from one edge to the next makes a difference of its own.
    int agree = 0;
    for (Eigen::Index i = 0; i < rates.size(); ++i)
      agree += std::abs(claimed[i] - rates[i]) < 1e-3 * (1e-2 + std::abs(rates[i]));
    CAPTURE(z, claimed.transpose(), rates.transpose());
    CHECK(agree >= rates.size() - 1);
  }
}

TEST_CASE("Marks that are too near are pushed apart, or put together") {
  const Model model = trefoil(40);
  network::Network network = greedy_network(model, 10.0);
  const double length = model.structure.rods[0].length();
  const auto& first = std::get<springs::OnRod>(network.structure.cables[0].a);
  auto& second = std::get<springs::OnRod>(network.structure.cables[1].a);
  const model::Gaps gaps{.clearance = 0.0, .mark_distance = 0.01 * length};
  const double radius = model::outer_radii(network.structure)[0];
  for (const double apart : {0.0, 0.003, 0.008, 0.012}) {
    second.s = first.s + apart * length;
    const double by_rods =
        missing_gap(network.structure, network.state, {.clearance = 0.0, .mark_distance = 0.0});
    const double missing = apart > 0 ? std::max(0.0, 0.01 - apart) * length / radius : 0.0;
    CHECK(missing_gap(network.structure, network.state, gaps) ==
          Approx(std::max(by_rods, missing)));
  }
  second.s = first.s + 0.003 * length;
  const auto at = solved(network.structure, network.state);
  const LocalModel local = local_model(at, target_of(model, network), nullptr);
  const StepBounds bounds = gap_bounds(at, local, gaps);
  // Two bounds that only the same place fulfils.
  const Eigen::VectorXd sorted = bounds.lower;
  CHECK((sorted.array() - 0.003 * length).abs().minCoeff() < 1e-9);
  CHECK((sorted.array() + 0.003 * length).abs().minCoeff() < 1e-9);
}
