// The distance of a structure from the shape it is meant to take (paper section 5.3, eq. 7).
#pragma once

#include <Eigen/Core>
#include <optional>
#include <tencer/equilibrium/system.hpp>
#include <tencer/model/target.hpp>
#include <tencer/registration/rigid.hpp>
#include <vector>

namespace tencer::sensitivity {

// How far a state is from the target, in length units where nothing else is said. Where the target
// has views |x - y| is what they see of it (model::seen_metric).
struct Deviation {
  double value = 0.0;        // T = sum w |x - y|^2, y the aligned target (eq. 7)
  double max = 0.0;          // largest |x - y| over the vertices with w > 0
  double rms = 0.0;          // sqrt(T / sum w)
  double max_percent = 0.0;  // of the diagonal of the target's axis-aligned bounding box, all
  double rms_percent = 0.0;  // vertices counted
  registration::RigidMotion motion{};  // takes the target to y
};
Deviation deviation(const model::Target& target, const model::State& state);

// The target's views as they look at the state that the target is aligned with.
std::vector<model::View> views_at(const model::Target& target, const model::State& state);

// T's derivatives in the free unknowns of a system at a state: T is stationary in the alignment, so
// the gradient is that with the alignment held, 2 w (x - y). The Hessian knows that the alignment
// follows x: it is what it is without that less a matrix of rank 6 (in the plane 3).
class Distance {
 public:
  // Throws as model::validate(target, structure).
  Distance(const model::Target& target, const equilibrium::System& system,
           const model::State& state);

  const Deviation& deviation() const { return deviation_; }
  const Eigen::VectorXd& gradient() const { return gradient_; }  // size
  // The Hessian times each column of v (size x k).
  Eigen::MatrixXd hessian_times(const Eigen::Ref<const Eigen::MatrixXd>& v) const;

  // T as a sum of squares, |residual|^2: sqrt(w) (x - y) of every vertex of every rod, 3 entries
  // each. T's gradient is 2 R^T residual for the matrix R of residual_rates.
  const Eigen::VectorXd& residual() const { return residual_; }
  // How the residual varies with displacements v (size x k) less their rigid part, which the
  // alignment takes up: sqrt(w) (v - rigid motion of y nearest to v). Without alignment v is taken
  // as it is. What views do not see is left out of this and of the residual.
  Eigen::MatrixXd residual_rates(const Eigen::Ref<const Eigen::MatrixXd>& v) const;

 private:
  Eigen::MatrixXd in_rows(const Eigen::Ref<const Eigen::MatrixXd>& v) const;

  Deviation deviation_;
  Eigen::VectorXd gradient_, residual_;
  // Takes a distance, in the frame of the state, to what is seen of it; not set: all of it is.
  std::optional<Eigen::Matrix3d> seeing_;
  Eigen::VectorXd weights_;  // per free unknown; 0 for what is not a position
  Eigen::VectorXd roots_;    // sqrt(w) per row of the residual
  std::vector<int> rows_;    // per free unknown its row in the residual, -1 for none
  // What the alignment takes up (src/alignment.hpp), forces in free unknowns: for T, and as it
  // would be for x = y.
  Eigen::MatrixXd motions_;  // 3 N x 6, 3 or 0
  Eigen::MatrixXd forces_, gauss_forces_;
  Eigen::MatrixXd compliance_, gauss_compliance_;
};

}  // namespace tencer::sensitivity
