// How the other cables make up for one that is being taken out: damped Gauss-Newton steps of their
// stiffnesses and attachments.
#pragma once

#include <Eigen/Core>
#include <tencer/sensitivity/target.hpp>
#include <tencer/sensitivity/tracker.hpp>
#include <tencer/sparsify/network.hpp>
#include <vector>

#include "design_variables.hpp"

namespace tencer::sparsify {

class Refitter {
 public:
  // The variables are those of the network's cables, as in refine().
  Refitter(const Network& network, const sensitivity::Target& target, const RefineSetup& setup);

  struct Refit {
    double distance = 0.0;  // T after the step, to first order, relative to the setup's percent
    std::vector<springs::Cable> cables{};
  };

  // The step from a usable configuration with these cables; the stiffness of cable `held` stays.
  Refit at(const sensitivity::Configuration& configuration, int held) const;

 private:
  const sensitivity::Target& target_;
  std::vector<Variable> variables_;
  std::vector<sensitivity::Parameter> parameters_;
  double root_unit_ = 1.0;
};

}  // namespace tencer::sparsify
