// The stages from a prepared scene to networks of cables, by either method.
#pragma once

#include <optional>
#include <tencer/pipeline/design.hpp>
#include <tencer/pipeline/prepare.hpp>
#include <vector>

namespace tencer::pipeline {

// A scene that is ready to be designed.
struct Task {
  const model::Scene& scene;
  Prepared prepared{};
  std::optional<ground_structure::Problem> released{};  // without pins, when they are handed over
  std::optional<optimize::Backend> backend{};           // the one the scene names, when it is used

  // Who makes the last fit of eliminations; not set: their own Gauss-Newton steps.
  std::optional<optimize::Backend> fit_optimizer() const {
    if (scene.design.optimizer == model::Optimizer::gauss_newton) return std::nullopt;
    return backend;
  }
};

struct Outcome {
  // The fewest cables first, each closer to the target than those with fewer. Never empty.
  std::vector<network::Network> networks{};
  int asked = 0;  // index of the one that answers what the scene asks for
  std::vector<model::StageRow> trace{};
  bool interrupted = false;
};

// every_number: networks of every number of cables on the way are fitted.
Outcome run_method(const Task& task, bool every_number, const RunOptions& options);

}  // namespace tencer::pipeline
