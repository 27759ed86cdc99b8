#include "quasi_newton.hpp"

#include <utility>
#include <vector>

namespace tencer::curves {
namespace {

using Eigen::Matrix3Xd;

constexpr std::size_t memory = 10;

double dot(const Matrix3Xd& a, const Matrix3Xd& b) { return a.cwiseProduct(b).sum(); }

}  // namespace

Matrix3Xd QuasiNewton::direction(const Matrix3Xd& gradient) const {
  Matrix3Xd result = gradient;
  std::vector<double> parts(steps_.size());
  for (std::size_t k = steps_.size(); k-- > 0;) {
    parts[k] = dot(steps_[k].step, result) / steps_[k].curvature;
    result -= parts[k] * steps_[k].change;
  }
  result = result * metric_;
  if (!steps_.empty()) {
    const Step& last = steps_.back();
    result *= last.curvature / dot(last.change, last.change * metric_);
  }
  for (std::size_t k = 0; k < steps_.size(); ++k)
    result += (parts[k] - dot(steps_[k].change, result) / steps_[k].curvature) * steps_[k].step;
  return -result;
}

void QuasiNewton::learn(const Matrix3Xd& step, const Matrix3Xd& change) {
  const double curvature = dot(step, change);
  if (curvature <= 1e-8 * step.norm() * change.norm()) return;
  steps_.push_back({step, change, curvature});
  if (steps_.size() > memory) steps_.pop_front();
}

}  // namespace tencer::curves
