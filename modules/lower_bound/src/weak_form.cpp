#include "weak_form.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace tencer::lower_bound {
namespace {

using Eigen::Index;

// The cubic B-spline of knots 0, 1, 2, 3, 4.
double b_spline(double u) {
  const double far = std::max(0.0, 2 - std::abs(u - 2));
  const double near = std::max(0.0, 1 - std::abs(u - 2));
  return far * far * far / 4 - near * near * near;
}

// n x k: every function is 0, and so is its slope, at both ends.
Eigen::MatrixXd spline_basis(const Eigen::VectorXd& l) {
  const Index n = l.size() + 1;
  const Index count = std::clamp<Index>(n / 2 - 3, 1, 12);
  Eigen::MatrixXd basis = Eigen::MatrixXd::Zero(n, count);
  double s = 0;
  for (Index i = 1; i + 1 < n; ++i) {
    s += l[i - 1];
    for (Index k = 0; k < count; ++k)
      basis(i, k) = b_spline(s / l.sum() * static_cast<double>(count + 3) - static_cast<double>(k));
  }
  return basis;
}

// g(0) of psi: what multiplies positions in sum psi_i . (t_i - t_(i-1)).
Eigen::Matrix3Xd second_difference(const Eigen::Matrix3Xd& psi, const Eigen::VectorXd& l) {
  Eigen::Matrix3Xd h = Eigen::Matrix3Xd::Zero(3, psi.cols());
  for (Index j = 0; j < l.size(); ++j) {
    const Eigen::Vector3d slope = (psi.col(j) - psi.col(j + 1)) / l[j];
    h.col(j + 1) += slope;
    h.col(j) -= slope;
  }
  return h;
}

// What a moment A + F x y adds to g.
Eigen::Matrix3Xd of_moment(const WeakForm& form, const Eigen::Matrix3Xd& psi,
                           const Eigen::Vector3d& A, const Eigen::Vector3d& F) {
  Eigen::Matrix3Xd g = Eigen::Matrix3Xd::Zero(3, psi.cols());
  for (Index i = 1; i + 1 < psi.cols(); ++i) {
    const Eigen::Vector3d test = psi.col(i);
    const Eigen::Vector3d moment = A + F.cross(form.y.col(i));
    g.col(i) -= form.along.col(i).cross(test).cross(F);
    const Eigen::Vector3d half = test.cross(moment) / 2;
    g.col(i + 1) -= half;
    g.col(i - 1) += half;
  }
  return g;
}

Parameters coefficients(const WeakForm& form, const Eigen::Matrix3Xd& psi) {
  Parameters c = Parameters::Zero();
  for (Index i = 1; i + 1 < psi.cols(); ++i) {
    const Eigen::Vector3d turn = form.along.col(i).cross(psi.col(i));
    c.head<3>() += turn;
    c.tail<3>() += form.y.col(i).cross(turn);
  }
  return c;
}

void add_tests(WeakForm& form) {
  const Index n = form.vertices();
  const Index count = 3 * form.splines.cols();
  form.psi = form.g_free = Eigen::MatrixXd::Zero(3 * n, count);
  form.g_per.fill(form.psi);
  form.c = Eigen::MatrixXd::Zero(6, count);
  for (Index z = 0; z < count; ++z) {
    Eigen::Matrix3Xd psi = Eigen::Matrix3Xd::Zero(3, n);
    psi.row(z % 3) = form.splines.col(z / 3).transpose();
    form.psi.col(z) = psi.reshaped();
    form.g_free.col(z) = second_difference(psi, form.l).reshaped();
    form.c.col(z) = coefficients(form, psi);
    for (int k = 0; k < 3; ++k) {
      const Eigen::Vector3d unit = Eigen::Vector3d::Unit(k);
      const Eigen::Vector3d none = Eigen::Vector3d::Zero();
      form.g_per[k].col(z) = of_moment(form, psi, unit, none).reshaped();
      form.g_per[3 + k].col(z) = of_moment(form, psi, none, unit).reshaped();
    }
  }
  form.d = form.y.reshaped().transpose() * form.g_free;
}

}  // namespace

Eigen::MatrixXd WeakForm::g(const Parameters& p) const {
  Eigen::MatrixXd sum = g_free;
  for (int k = 0; k < 6; ++k) sum += p[k] * g_per[k];
  return sum;
}

WeakForm weak_form(const Stretch& stretch) {
  const Index n = stretch.target.cols();
  const double unit = stretch.rest_lengths.sum();
  WeakForm form{.y = (stretch.target.colwise() - stretch.target.rowwise().mean()) / unit,
                .l = stretch.rest_lengths / unit,
                .v = Eigen::VectorXd::Zero(n),
                .along = Eigen::Matrix3Xd::Zero(3, n),
                .error = stretch.error / unit,
                .most_bend = stretch.most_bend,
                .slenderness = stretch.slenderness * unit * unit};
  for (Index i = 1; i + 1 < n; ++i) {
    form.v[i] = (form.l[i - 1] + form.l[i]) / 2;
    form.along.col(i) = (form.y.col(i + 1) - form.y.col(i - 1)) / 2;
  }
  form.splines = spline_basis(form.l);
  add_tests(form);
  return form;
}

}  // namespace tencer::lower_bound
