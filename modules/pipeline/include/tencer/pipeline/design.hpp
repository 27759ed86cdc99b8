// From a scene to a certified network of cables, by the route of the paper (section 5).
#pragma once

#include <functional>
#include <stop_token>
#include <tencer/core/error.hpp>
#include <tencer/core/log.hpp>
#include <tencer/io/design.hpp>
#include <tencer/io/scene.hpp>
#include <tencer/optimize/backend.hpp>
#include <tencer/pipeline/backends.hpp>
#include <tencer/sparsify/network.hpp>
#include <vector>

namespace tencer::pipeline {

struct DesignOptions {
  std::vector<optimize::Backend> backends = pipeline::backends();
  // The best design so far is returned, marked as interrupted and without the last check.
  std::stop_token stop{};
  std::function<void(const sparsify::Progress&)> progress{};  // may be empty
  core::Log log{};                                            // may be empty
};

// Dense springs, pruning, greedy decimation, sparsification, sliding, thinning; then the certificate of the
// built form, with inextensible cables, and a check that it settles from the target into the
// reported pose. A target in which the rods rest by themselves has a design without cables. Errors
// name the scene's file and the key: an optimizer that is not in the build, rules that allow no
// cable, a rod that crosses itself, anchors that do not enclose the target.
core::Expected<io::Design> design(const io::Scene& scene, const DesignOptions& options = {});

}  // namespace tencer::pipeline
