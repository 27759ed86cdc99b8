// Springs that are taken out one after another: the structure's Hessian pattern is kept while they
// go, since working it out again costs more than a solve.
#pragma once

#include <tencer/network/stage.hpp>
#include <tencer/network/stage_recorder.hpp>
#include <vector>

namespace tencer::sparsify {

class SpringSet {
 public:
  SpringSet(network::Network network, const network::Control& control);

  int count() const { return count_; }
  const model::State& state() const { return state_; }
  // Only the springs that are left.
  network::Network network() const;

  // Tension of every spring at the state; that of springs taken out is infinite.
  Eigen::VectorXd tensions() const;

  // From now on equilibria are this accurate, and solved for also after a request to stop.
  void finish_with(double tolerance) {
    options_.tolerance = tolerance;
    options_.stop = {};
  }
  // Takes springs out; solve() then finds the equilibrium from the present state.
  void take_out(const std::vector<int>& springs);
  equilibrium::Reason solve();
  // Makes the present springs and state those that revert() returns to.
  void commit();
  void revert();

  const network::SolveCounts& counts() const { return counts_; }

 private:
  equilibrium::System system_;
  equilibrium::Linearisation workspace_;
  equilibrium::SolveOptions options_;
  model::State state_, committed_state_;
  std::vector<springs::Cable> springs_;  // those taken out have stiffness 0
  std::vector<bool> present_, committed_present_;
  std::vector<double> stiffness_;
  int count_ = 0, committed_count_ = 0;
  network::SolveCounts counts_;
};

}  // namespace tencer::sparsify
