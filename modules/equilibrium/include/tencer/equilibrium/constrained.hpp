// The structure as it is built, with inextensible cables, to second order about a state: the
// bordered matrix [H A; A^T 0], H the Hessian of the Lagrangian and A the gradients of the taut
// cables' lengths. Stability, natural frequencies and the response to errors come from it.
#pragma once

#include <Eigen/Core>
#include <tencer/equilibrium/rigid_modes.hpp>
#include <tencer/equilibrium/solve.hpp>
#include <tencer/equilibrium/system.hpp>
#include <vector>

namespace tencer::equilibrium {

// The cables that pull with more than 1e-9 of the largest tension; the others are slack.
std::vector<int> taut_cables(const Eigen::VectorXd& tensions);

// The structure with the cables of `taut` alone, as springs of the same tensions (one per cable of
// the structure) at this state: on motions that keep their lengths its Hessian is that of the
// Lagrangian, and off them it is regular.
System taut_system(const model::Structure& structure, const model::State& state,
                   const Eigen::VectorXd& tensions, const std::vector<int>& taut);

// A: the derivative of every cable's length in the free unknowns, size x cables.
Eigen::MatrixXd length_gradients(const System& system, const model::State& state);

// How the unknowns and the cables' tensions change; one column a right-hand side.
struct ConstrainedResponse {
  Eigen::MatrixXd motion{};   // size x k, without rigid part
  Eigen::MatrixXd tension{};  // cables x k
};

// Eigenpairs of H v = lambda M v, ascending; fewer than asked for where there are fewer.
struct [[nodiscard]] ConstrainedModes {
  Eigen::VectorXd values{};
  Eigen::MatrixXd motions{};  // size x k; 0 where there is no mass. Largest entries 1.
  bool converged = false;
};

// H on the motions that keep the lengths of `constraints` and are not rigid, factorised.
class ConstrainedHessian {
 public:
  // constraints: size x m, length_gradients of all the system's cables or no columns, and then the
  // cables are the springs they are. mass: M's diagonal, per free unknown, 0 for what is not a
  // position. The system must outlive this.
  ConstrainedHessian(const System& system, const model::State& state, Eigen::MatrixXd constraints,
                     const Eigen::VectorXd& mass);

  // H + shift M. Returns false when it is singular; nothing below may be asked then.
  [[nodiscard]] bool factorise(double shift = 0);
  double shift() const { return shift_; }

  // Of what is factorised: negative eigenvalues, and the diagonal (which rounding is told by).
  int negative() const { return negative_; }
  const Eigen::VectorXd& diagonal() const { return diagonal_; }
  const std::vector<RigidModes>& rigid() const { return at_.rigid; }

  // dx and dt of [H A; A^T 0] [dx; dt] = [force; length], rigid motion projected out. Dependent
  // cables share their tensions with the least sum of squares. force: size x k, length: m x k.
  ConstrainedResponse respond(const Eigen::MatrixXd& force, const Eigen::MatrixXd& length) const;
  // dx for length = 0, for one force.
  Eigen::VectorXd motion(const Eigen::VectorXd& force) const;

  // The lowest eigenpairs of H, by Lanczos on the inverse of H + shift M, which must have no
  // negative eigenvalue.
  ConstrainedModes lowest(int count) const;

 private:
  const System& system_;
  Eigen::MatrixXd constraints_;
  Eigen::VectorXd spring_stiffness_;  // of the springs that stand for the constraints
  Eigen::VectorXd root_mass_;
  Eigen::MatrixXd rigid_;  // orthonormal, in mass-weighted coordinates
  bool spins_ = false;     // a straight rod with frames may turn about itself, moving no mass
  Linearisation at_;
  Eigen::VectorXd diagonal_;
  Eigen::MatrixXd compliance_columns_;
  Eigen::MatrixXd stiffness_;  // pseudo-inverse of the cables' compliance
  int rank_ = 0;               // independent constraints
  double shift_ = 0;
  int negative_ = 0;
};

}  // namespace tencer::equilibrium
