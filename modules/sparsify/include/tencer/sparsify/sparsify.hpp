// Fewer cables by a sparsity term with growing weight (paper section 5.3, eq. 6 and 8).
#pragma once

#include <limits>
#include <tencer/model/target.hpp>
#include <tencer/network/stage.hpp>
#include <tencer/optimize/backend.hpp>
#include <tencer/sparsify/outer.hpp>
#include <vector>

namespace tencer::sparsify {

struct SparsifyOptions {
  double max_error_percent = 1.0;  // the largest distance to the target that is accepted
  // The objective is (rms / max_error_percent)^2 + weight * unit * mean of sqrt(q), q the force
  // densities relative to their mean at the start; the weights are tried in this order.
  double unit = 1e-4;
  std::vector<double> weights{0, 1, 10, 100, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8};
  int bisections = 3;  // between the last two weights, when the last one's network is not accepted
  double max_cable_length = std::numeric_limits<double>::infinity();  // see model::Rules
  OuterOptions outer{};

  // Throws std::invalid_argument, naming the field, unless the numbers make sense.
  void validate() const;
};

// Minimises the objective for each weight, from the last accepted network; takes out the cables
// whose stiffness vanished; stops at the first weight whose network would be further from the
// target than accepted, or unstable. With anchors, the cables to them go through all weights first.
// Every accepted weight has a row in the trace. A network that is not in equilibrium with every
// cable pulling comes back as it is, with its fault.
network::StageResult sparsify(const network::Network& network, const model::Target& target,
                              const optimize::Backend& backend, const SparsifyOptions& options = {},
                              const network::Control& control = {});

}  // namespace tencer::sparsify
