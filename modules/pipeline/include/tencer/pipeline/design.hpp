// From a scene to certified networks of cables.
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

// The scene's method: force balance at the target, or dense springs with pruning, greedy
// decimation, sparsification and sliding; then thinning. Of the networks found the one the scene
// asks for (design.cables, else the fewest cables within design.max_error) is certified in its
// built form, with inextensible cables, and let go at the target, from where it has to settle into
// the reported pose; when it fails, the next best are tried. A target in which the rods rest by
// themselves has a design without cables. Errors name the scene's file and the key: an optimizer
// that is not in the build, rules that allow no cable, a rod that crosses itself, anchors that do
// not enclose the target.
core::Expected<io::Design> design(const io::Scene& scene, const DesignOptions& options = {});

// All numbers of cables on the way down in one run: certified designs, the fewest cables first,
// each closer to the target than those with fewer. Never empty.
core::Expected<std::vector<io::Design>> trade_off(const io::Scene& scene,
                                                  const DesignOptions& options = {});

}  // namespace tencer::pipeline
