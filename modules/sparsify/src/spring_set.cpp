#include "spring_set.hpp"

#include <limits>
#include <tencer/springs/law.hpp>
#include <utility>

namespace tencer::sparsify {
namespace {

std::vector<double> stiffness_of(const std::vector<springs::Cable>& cables) {
  std::vector<double> stiffness;
  for (const auto& cable : cables) stiffness.push_back(cable.stiffness);
  return stiffness;
}

}  // namespace

SpringSet::SpringSet(network::Network network, const network::Control& control)
    : system_(network.structure),
      options_(control.solve),
      state_(network.state),
      committed_state_(std::move(network.state)),
      springs_(network.structure.cables),
      present_(springs_.size(), true),
      committed_present_(present_),
      stiffness_(stiffness_of(springs_)),
      count_(static_cast<int>(springs_.size())),
      committed_count_(count_) {
  options_.stop = control.stop;
}

network::Network SpringSet::network() const {
  network::Network result{system_.structure(), state_};
  result.structure.cables.clear();
  for (std::size_t i = 0; i < springs_.size(); ++i)
    if (present_[i]) result.structure.cables.push_back(springs_[i]);
  return result;
}

Eigen::VectorXd SpringSet::tensions() const {
  Eigen::VectorXd result(static_cast<Eigen::Index>(springs_.size()));
  for (std::size_t i = 0; i < springs_.size(); ++i)
    result[static_cast<Eigen::Index>(i)] =
        present_[i]
            ? springs::tension(springs_[i], model::span_of(system_.stencils()[i], state_).norm())
            : std::numeric_limits<double>::infinity();
  return result;
}

void SpringSet::take_out(const std::vector<int>& springs) {
  for (const int i : springs) {
    present_[i] = false;
    springs_[i].stiffness = 0;
    --count_;
  }
}

equilibrium::Reason SpringSet::solve() {
  system_.set_cables(springs_);
  auto result = equilibrium::solve(system_, state_, options_, workspace_);
  counts_ += {.solves = 1, .iterations = result.iterations};
  state_ = std::move(result.state);
  return result.reason;
}

void SpringSet::commit() {
  // A pattern half of which is unused is worth working out again.
  if (2 * count_ < static_cast<int>(springs_.size())) {
    std::vector<springs::Cable> left;
    std::vector<double> stiffness;
    for (std::size_t i = 0; i < springs_.size(); ++i)
      if (present_[i]) {
        left.push_back(springs_[i]);
        stiffness.push_back(stiffness_[i]);
      }
    springs_ = std::move(left);
    stiffness_ = std::move(stiffness);
    present_.assign(springs_.size(), true);
    system_.set_cables(springs_);
  }
  committed_present_ = present_;
  committed_count_ = count_;
  committed_state_ = state_;
}

void SpringSet::revert() {
  present_ = committed_present_;
  count_ = committed_count_;
  state_ = committed_state_;
  for (std::size_t i = 0; i < springs_.size(); ++i)
    springs_[i].stiffness = present_[i] ? stiffness_[i] : 0;
}

}  // namespace tencer::sparsify
