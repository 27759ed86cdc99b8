#include <algorithm>
#include <catch2/catch.hpp>
#include <tencer/network/rest_length.hpp>
#include <tencer/sparsify/sparsify.hpp>

#include "backends.hpp"
#include "fixtures/networks.hpp"

using namespace tencer;
using namespace tencer::fixtures;
using network::Network;

namespace {

int external(const Network& network) {
  return static_cast<int>(std::ranges::count_if(network.structure.cables, model::is_external));
}

}  // namespace

TEST_CASE(
    "Sparsification gives fewer cables within the tolerance, more where it is tighter, with every "
    "optimizer") {
  const Model model = trefoil();
  const Network start = greedy_network(model);
  const auto target = target_of(model, start);
  const double tightest = 1.01 * max_percent(model, start);
  for (const auto& backend : backends()) {
    CAPTURE(backend.name);
    const auto result =
        sparsify::sparsify(start, target, backend, {.max_error_percent = 1.0, .outer = quick()});
    CHECK(result.valid());
    CHECK(max_percent(model, result.network) <= 1.0);
    CHECK(cable_count(result.network) <= cable_count(start) / 2);
    CHECK(cable_tensions(result.network).minCoeff() > 0);
    CHECK(network::stiffest_eigenvalue(result.network) > 0);
    REQUIRE_FALSE(result.trace.empty());
    for (std::size_t i = 0; i < result.trace.size(); ++i) {
      CHECK(result.trace[i].max_percent <= 1.0);
      CHECK_FALSE(result.trace[i].note.empty());
      if (i > 0) CHECK(result.trace[i].cables <= result.trace[i - 1].cables);
    }
    CHECK(result.trace.back().cables == cable_count(result.network));
    // Solved again, and more tightly, it is still there.
    const auto again = equilibrium::solve(equilibrium::System(result.network.structure),
                                          result.network.state, {.tolerance = 1e-12});
    CHECK(again.usable());
    CHECK(max_percent(model, {result.network.structure, again.state}) ==
          Approx(max_percent(model, result.network)).epsilon(1e-4));
    const auto tight = sparsify::sparsify(start, target, backend,
                                          {.max_error_percent = tightest, .outer = quick()});
    CHECK(tight.valid());
    CHECK(max_percent(model, tight.network) <= tightest);
    CHECK(cable_count(tight.network) > cable_count(result.network));
  }
}

TEST_CASE("A tolerance that is out of reach leaves the network as it was") {
  const Model model = trefoil();
  const Network start = greedy_network(model);
  const auto target = target_of(model, start);
  for (const auto& backend : backends()) {
    CAPTURE(backend.name);
    const auto result =
        sparsify::sparsify(start, target, backend, {.max_error_percent = 1e-7, .outer = quick()});
    CHECK(result.valid());
    CHECK(cable_count(result.network) == cable_count(start));
    CHECK(max_percent(model, result.network) == Approx(max_percent(model, start)));
  }
}

TEST_CASE("External cables are sparsified first") {
  const Model model = hung_helix();
  const Network start = greedy_network(model, 1.5);
  const auto target = target_of(model, start);
  for (const auto& backend : backends()) {
    CAPTURE(backend.name);
    const auto result =
        sparsify::sparsify(start, target, backend, {.max_error_percent = 3.0, .outer = quick()});
    CHECK(result.valid());
    CHECK(max_percent(model, result.network) <= 3.0);
    CHECK(cable_count(result.network) < cable_count(start));
    CHECK(external(result.network) <= external(start));
    const auto is_external = [](const model::StageRow& row) {
      return row.note.starts_with("external");
    };
    const auto& trace = result.trace;
    CHECK(std::ranges::any_of(trace, is_external));
    CHECK(std::is_partitioned(trace.begin(), trace.end(), is_external));
  }
}

TEST_CASE("A network that is not in equilibrium is not sparsified, and says so") {
  const Model model = trefoil();
  Network network = greedy_network(model);
  const auto target = target_of(model, network);
  network.structure.cables[0].stiffness *= 2;
  for (const auto& backend : backends()) {
    const auto result = sparsify::sparsify(network, target, backend);
    CHECK(result.fault == network::Fault::not_in_equilibrium);
    CHECK(cable_count(result.network) == cable_count(network));
    CHECK(result.trace.back().note.ends_with(describe(result.fault)));
  }
}

TEST_CASE("Sparsification that is stopped returns the best so far") {
  const Model model = trefoil();
  const Network start = greedy_network(model);
  const auto target = target_of(model, start);
  for (const auto& backend : backends()) {
    CAPTURE(backend.name);
    std::stop_source source;
    int rows = 0;
    const auto result =
        sparsify::sparsify(start, target, backend, {.max_error_percent = 1.0, .outer = quick()},
                           {.stop = source.get_token(), .progress = [&](const network::Progress&) {
                              if (++rows == 2) source.request_stop();
                            }});
    CHECK(result.interrupted);
    CHECK(result.valid());
    CHECK(result.trace.size() == 2);
    CHECK(max_percent(model, result.network) <= 1.0);
  }
}
