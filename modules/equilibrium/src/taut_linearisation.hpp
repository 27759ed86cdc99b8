// A structure with inextensible, unilateral cables to first order about a state.
#pragma once

#include <Eigen/Core>
#include <Eigen/LU>
#include <tencer/equilibrium/solve.hpp>
#include <vector>

namespace tencer::equilibrium {

// A Newton step: the motion of the free unknowns and the tensions after it.
struct TautStep {
  Eigen::VectorXd motion{};
  Eigen::VectorXd tensions{};  // >= 0
  bool solved = false;         // false: no set of taut cables was found
};

// One more equation for a step in which the cables' lengths change too: along . motion + rate *
// part = ahead.
struct WayEquation {
  Eigen::VectorXd along{};  // per free unknown
  double rate = 0.0;
  double ahead = 0.0;
};

// A Newton step in which the taut cables stay taut, and how far on it goes.
struct HeldStep {
  Eigen::VectorXd motion{};
  Eigen::VectorXd tensions{};  // of any sign; 0 of slack cables
  double part = 0.0;
  bool solved = false;
};

// The Hessian of the Lagrangian with the taut cables as stiff springs besides: on motions that keep
// their lengths the springs change nothing, and when it is positive definite so is the Hessian on
// these motions. Positive definite otherwise too, but for what springs so stiff still give.
class TautLinearisation {
 public:
  // forces: in the geometric stiffness; their tensions are the cables', and those above zero taut.
  // Sets the cables of `system` to the springs. False unless positive definite.
  bool linearise(System& system, const model::State& state, const InternalForces& forces);

  // Towards gradient = 0 where every cable gets longer by `gap` at most, and by `gap` where it
  // pulls: a linear complementarity problem. gradient: with `tensions`.
  TautStep step(const Eigen::VectorXd& gradient, const Eigen::VectorXd& tensions,
                const Eigen::VectorXd& gap) const;

  // The same with the cables told to be taut, whatever their tensions, and of any inertia: false
  // where it is singular.
  bool linearise(System& system, const model::State& state, const InternalForces& forces,
                 const std::vector<bool>& taut);

  // Of the Hessian on motions that keep the taut cables' lengths: how many of its eigenvalues are
  // negative. Of what was linearised with taut cables.
  int negative() const { return negative_; }

  // Towards gradient = 0 where the taut cables get longer by `gap`, and by `growth` (per cable) for
  // all of the way besides.
  HeldStep step(const Eigen::VectorXd& gradient, const Eigen::VectorXd& tensions,
                const Eigen::VectorXd& gap, const Eigen::VectorXd& growth,
                const WayEquation& equation) const;

  // How much longer a motion makes every cable.
  Eigen::VectorXd growth(const Eigen::VectorXd& motion) const {
    return pulls_.transpose() * motion;
  }

  const std::vector<RigidModes>& rigid() const { return at_.rigid; }

 private:
  bool factorise(System& system, const model::State& state, const InternalForces& forces);
  void border_rigid_motion(const System& system);
  Eigen::MatrixXd solve(const Eigen::MatrixXd& forces) const;

  Linearisation at_{};
  // The border that keeps a solve off rigid motion where forces are out of balance, and H alone
  // resists it: [anchors, basis], H^-1 of them with H anchored, and the matrix of the unknowns that
  // they add.
  Eigen::MatrixXd border_{};
  Eigen::MatrixXd border_motions_{};
  Eigen::PartialPivLU<Eigen::MatrixXd> border_matrix_{};
  Eigen::VectorXd springs_{};  // per cable, their stiffness; 0 where slack
  int negative_ = 0;
  Eigen::MatrixXd pulls_{};       // size x cables, see length_gradients
  Eigen::MatrixXd motions_{};     // size x cables, H^-1 pulls
  Eigen::MatrixXd compliance_{};  // cables x cables, pulls^T H^-1 pulls
};

}  // namespace tencer::equilibrium
