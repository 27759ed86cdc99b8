// The paper's route from target to network on a published model, stage by stage.
// Usage: bench_design_route FOLDER MODEL OPTIMIZER [MAX_PERCENT]
// MAX_PERCENT, the distance accepted, is by default that of the published design.
#include <algorithm>
#include <cstdio>
#include <string>
#include <tencer/core/scale.hpp>
#include <tencer/optimize_ipopt/backends.hpp>
#include <tencer/optimize_nlopt/backends.hpp>
#include <tencer/sparsify/decimate.hpp>
#include <tencer/sparsify/dense.hpp>
#include <tencer/sparsify/rest_length.hpp>
#include <tencer/sparsify/rules.hpp>
#include <tencer/sparsify/slide.hpp>
#include <tencer/sparsify/sparsify.hpp>
#include <tencer/sparsify/thin.hpp>

#include "published_model.hpp"

using namespace tencer;

namespace {

// Length in units of all rods together, energy in units of the stiffest rod's EI over that.
void scale(bench::PublishedModel& model) {
  core::Scale unit{.length = 0, .energy = 0};
  for (const auto& rod : model.structure.rods) unit.length += rod.length();
  for (const auto& rod : model.structure.rods)
    unit.energy = std::max(unit.energy, rod.section.EI1 / unit.length);
  for (auto& rod : model.structure.rods) {
    rod.rest_lengths /= unit.length;
    rod.section.EA /= unit.force();
    for (double* stiffness : {&rod.section.EI1, &rod.section.EI2, &rod.section.GJ})
      *stiffness /= unit.bending();
  }
  model.structure.anchors /= unit.length;
  for (auto& points : model.target) points /= unit.length;
  model.structure.cables.clear();
}

std::vector<optimize::Backend> backends() {
  std::vector<optimize::Backend> all;
  for (auto& backend : optimize_ipopt::backends()) all.push_back(backend);
  for (auto& backend : optimize_nlopt::backends()) all.push_back(backend);
  return all;
}

sparsify::Network show(const sparsify::StageResult& result) {
  for (const auto& row : result.trace)
    std::printf("%-10s %8.2f %7d %9.4f %9.4f %7d %8d  %s\n", row.stage.c_str(), row.seconds,
                row.cables, row.max_percent, row.rms_percent, row.solves, row.iterations,
                row.note.c_str());
  if (!result.sound) std::printf("           not sound\n");
  return result.network;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 4 && argc != 5) {
    std::fprintf(stderr, "usage: bench_design_route FOLDER MODEL OPTIMIZER [MAX_PERCENT]\n");
    return 2;
  }
  const auto found = optimize::find_backend(backends(), argv[3]);
  if (!found) {
    std::fprintf(stderr, "%s\n", found.error().text().c_str());
    return 2;
  }
  const optimize::Backend backend = found.value();
  auto model = bench::read_published_model(std::string(argv[1]) + "/" + argv[2] + ".json");
  scale(model);
  sparsify::Rules rules;
  if (model.structure.rods.size() > 1 && !model.structure.planar) {
    rules.pairs.emplace();
    for (int a = 0; a < static_cast<int>(model.structure.rods.size()); ++a)
      for (int b = 0; b < a; ++b) rules.pairs->push_back({a, b});
  }
  const auto cables = sparsify::candidates(model.structure, model.target, rules);
  if (!cables) {
    std::fprintf(stderr, "%s\n", cables.error().text().c_str());
    return 2;
  }
  sparsify::Network network{model.structure,
                            equilibrium::make_state(model.structure, model.target)};
  network.structure.cables = sparsify::dense_springs(model.structure, model.target, cables.value());
  auto target = sensitivity::make_target(network.structure, model.target);
  std::printf("%s: %zu candidates; published: %d cables, %.2f %%\n", model.name.c_str(),
              cables->size(), model.cables, model.max_error_percent);
  network = show(sparsify::prune(network, target));
  network = show(sparsify::decimate(network, target));
  const auto rest = sparsify::smallest_stable_rest_length(network);
  std::printf("rest length %.2f, eigenvalue %.3g\n", rest.rho, rest.smallest_eigenvalue);
  const double tolerance = argc == 5 ? std::stod(argv[4]) : model.max_error_percent;
  network = show(sparsify::sparsify(network, target, backend, {.max_percent = tolerance}));
  network = show(sparsify::slide(network, target, rules, backend));
  network = show(sparsify::thin(network, target, rules, backend, {.max_percent = tolerance}));
}
