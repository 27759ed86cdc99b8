// Single steps along a branch of equilibria, see branch.hpp.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <tencer/equilibrium/system.hpp>
#include <vector>

#include "taut_linearisation.hpp"

namespace tencer::equilibrium {

struct BranchPose {
  model::State state{};
  InternalForces forces{};  // axial ones as the last step predicts them
  double part = 0.0;
  std::vector<bool> taut{};  // per cable
};

// Of a step in which the branch's own length grows by 1.
struct BranchTangent {
  Eigen::VectorXd motion{};
  Eigen::VectorXd tensions{};  // how they change
  double part = 0.0;
};

struct Spot {
  BranchPose pose{};
  BranchTangent tangent{};
  int negative = 0;
  double gone = 0.0;  // along the tangent of the spot before
};

class BranchSteps {
 public:
  BranchSteps(const model::Structure& structure, const Eigen::VectorXd& start_lengths,
              const Eigen::VectorXd& lengths);

  // The equilibrium next to a state with these tensions, at the start of the way.
  std::optional<Spot> start(const model::State& state, const Eigen::VectorXd& tensions);

  // The spot so far on along the tangent, or after `part` of the way where that is given. Not set:
  // it is too far away, or no neighbour.
  std::optional<Spot> reached(const Spot& from, double length, std::optional<double> part = {});

  // Lets a cable, which is about to, go slack or taut.
  [[nodiscard]] bool toggle(Spot& spot, Eigen::Index cable);

  // How far a cable is from going slack, or from getting taut; negative: it has.
  double margin(const BranchPose& pose, Eigen::Index cable) const;
  // The cable that is furthest beyond; -1: none is.
  Eigen::Index beyond(const BranchPose& pose) const;

  // Turn of an edge, or motion over the longest rod's length, for a unit of the branch's length;
  // where cables alone change, how much they do.
  double pace(const Spot& spot) const;

 private:
  // What was moved since a spot.
  struct Gone {
    Eigen::VectorXd motion{};
    double part = 0.0;
  };

  double size(const BranchPose& pose, const Eigen::VectorXd& motion) const;
  void move(BranchPose& pose, const Eigen::VectorXd& motion, double part,
            const Eigen::VectorXd& tensions) const;
  bool correct(BranchPose& pose, const WayEquation& equation, Gone& gone, double reach);
  bool find_tangent(Spot& spot, const WayEquation& equation);
  WayEquation along(const BranchTangent& tangent, double length) const;
  WayEquation at_part(double ahead) const;

  System system_;
  Eigen::VectorXd start_lengths_;
  Eigen::VectorXd change_;
  TautLinearisation at_{};
  // The square of the branch's own length: motion^2 weighted by metric_ and part^2 by rate_.
  Eigen::VectorXd metric_;
  double rate_ = 1.0;
  double longest_ = 0.0;
  double force_ = 0.0;  // EI / L^2
};

}  // namespace tencer::equilibrium
