// The stages from a prepared scene to networks of cables, by either method.
#pragma once

#include <tencer/pipeline/design.hpp>
#include <tencer/pipeline/prepare.hpp>
#include <tencer/sparsify/thin.hpp>
#include <vector>

namespace tencer::pipeline {

struct Outcome {
  // The fewest cables first, each closer to the target than those with fewer. Never empty.
  std::vector<sparsify::Network> networks{};
  int asked = 0;  // index of the one that answers what the scene asks for
  std::vector<io::TraceRow> trace{};
  bool interrupted = false;
};

// What cables can be chosen from, before and after pins are handed over to cables.
struct CandidateSets {
  std::vector<springs::Cable> with_pins{};
  std::vector<springs::Cable> without_pins{};  // empty when none are handed over
};

// every_number: networks of every number of cables on the way are fitted.
Outcome run_route(const io::DesignSettings& settings, const Prepared& prepared,
                  const CandidateSets& candidates, const optimize::Backend& backend,
                  bool every_number, const DesignOptions& options);

}  // namespace tencer::pipeline
