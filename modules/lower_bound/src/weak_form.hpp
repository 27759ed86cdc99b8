// The law of an elastica, tested with a function: what its positions say of its force and moment.
//
// With EI = 1, the moment at vertex i is M_i = A + F x x_i, and unit tangents t obey
// t_i - t_(i-1) = v c M_i x m, v the Voronoi length, m the mean of the two tangents and c the
// squared cosine of half the bend. Summed against vectors psi at the inner vertices this is, for
// x = y + delta,
//
//   d - p . c = - sum_i delta_i . g_i(p) + remainder,   p = (A, F),
//
// where d and c are linear in psi and known from the target y, and g is linear in psi and affine in
// p.
#pragma once

#include <Eigen/Core>
#include <array>

#include "stretch.hpp"

namespace tencer::lower_bound {

using Parameters = Eigen::Matrix<double, 6, 1>;  // A, then F

struct WeakForm {
  Eigen::Matrix3Xd y{};      // about its centre, in units of the stretch's length
  Eigen::VectorXd l{}, v{};  // edges; Voronoi lengths of vertices, 0 at the ends
  Eigen::Matrix3Xd along{};  // half of y_(i+1) - y_(i-1); 0 at the ends
  double error = 0.0;
  double most_bend = 0.0;
  double slenderness = 0.0;
  // Of test functions psi = basis z, z of 3 k entries: values per vertex, and what they give.
  Eigen::MatrixXd splines{};               // n x k: a test function is one of them along an axis
  Eigen::MatrixXd psi{};                   // 3 n x 3 k
  Eigen::MatrixXd g_free{};                // g(0), 3 n x 3 k
  std::array<Eigen::MatrixXd, 6> g_per{};  // what one unit of a parameter adds to it
  Eigen::MatrixXd c{};                     // 6 x 3 k
  Eigen::RowVectorXd d{};                  // 3 k

  Eigen::Index vertices() const { return y.cols(); }
  Eigen::MatrixXd g(const Parameters& p) const;
};

// The test functions are cubic splines that end with the stretch; n >= 8.
WeakForm weak_form(const Stretch& stretch);

}  // namespace tencer::lower_bound
