// What the weak form leaves out, bounded: how far d - p . c of test functions may be from 0.
#pragma once

#include <Eigen/Core>

#include "weak_form.hpp"

namespace tencer::lower_bound {

// Parameters p whose A is within A_radius of the centre's, and whose F within F_radius.
struct Range {
  Parameters centre = Parameters::Zero();
  double A_radius = 0.0;
  double F_radius = 0.0;
};

// Of any pose that follows the stretch, per vertex.
struct Pose {
  Eigen::VectorXd bend{};   // |t_i - t_(i-1)| is no larger
  Eigen::VectorXd drift{};  // half of delta_(i+1) - delta_(i-1) is no longer
  double stretch = 0.0;     // strains of edges are no larger
};

// What holds of all poses, and of those whose parameters are in a range.
Pose any_pose(const WeakForm& form);
Pose pose_within(const WeakForm& form, const Range& range);

// |d - p . c| <= fixed + per_A |A - A of centre| + per_F |F - F of centre|: the length of the
// vector of these of several test functions, a column of coefficients each.
struct Remainder {
  double fixed = 0.0;
  double per_A = 0.0;
  double per_F = 0.0;
};
Remainder remainder(const WeakForm& form, const Pose& pose, const Parameters& centre,
                    const Eigen::MatrixXd& z);

// Per vertex, what a test function costs by its size there, to weigh against g.
Eigen::VectorXd cost_of_size(const WeakForm& form, const Pose& pose, const Parameters& centre);

}  // namespace tencer::lower_bound
