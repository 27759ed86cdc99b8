// The stages from a prepared scene to networks of cables, by either method.
#pragma once

#include <span>
#include <tencer/pipeline/design.hpp>
#include <tencer/pipeline/prepare.hpp>
#include <tencer/sparsify/thin.hpp>

namespace tencer::pipeline {

struct Outcome {
  // The fewest cables first, each closer to the target than those with fewer. Never empty.
  std::vector<sparsify::Network> networks{};
  int asked = 0;  // index of the one that answers what the scene asks for
  std::vector<io::TraceRow> trace{};
  bool interrupted = false;
};

// every_number: networks of every number of cables on the way are fitted.
Outcome run_route(const io::DesignSettings& settings, const Prepared& prepared,
                  std::span<const springs::Cable> candidates, const optimize::Backend& backend,
                  bool every_number, const DesignOptions& options);

}  // namespace tencer::pipeline
