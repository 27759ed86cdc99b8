#include <Eigen/Eigenvalues>
#include <cmath>
#include <sstream>
#include <tencer/core/error.hpp>
#include <tencer/core/words.hpp>
#include <tencer/model/view.hpp>

namespace tencer::model {

Eigen::Matrix3d seen_metric(const std::vector<View>& views) {
  if (views.empty()) return Eigen::Matrix3d::Identity();
  Eigen::Matrix3d sum = Eigen::Matrix3d::Zero();
  double weights = 0;
  for (const View& view : views) {
    const Eigen::Vector3d along = view.direction.normalized();
    sum += view.weight * (Eigen::Matrix3d::Identity() - along * along.transpose());
    weights += view.weight;
  }
  return sum / weights;
}

Eigen::Matrix3d seeing(const std::vector<View>& views) {
  if (views.empty()) return Eigen::Matrix3d::Identity();
  constexpr double rounding = 1e-14;  // its root would be seen
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> eigen(seen_metric(views));
  const Eigen::Vector3d squares = eigen.eigenvalues();
  return eigen.eigenvectors() *
         (squares.array() > rounding).select(squares, 0).cwiseSqrt().matrix().asDiagonal() *
         eigen.eigenvectors().transpose();
}

std::vector<View> turned(std::vector<View> views, const Eigen::Matrix3d& rotation) {
  for (View& view : views) view.direction = rotation * view.direction;
  return views;
}

std::optional<std::string> view_problem(const std::vector<View>& views) {
  for (std::size_t i = 0; i < views.size(); ++i) {
    const std::string which = views.size() == 1 ? "" : "views[" + std::to_string(i) + "]: ";
    const auto& [direction, weight] = views[i];
    if (!direction.allFinite() || !(direction.norm() > 0) || !std::isfinite(direction.norm()))
      return which + "expected a direction [x, y, z] that is not zero";
    if (!(weight > 0) || !std::isfinite(weight)) return which + "expected a weight above 0";
  }
  return std::nullopt;
}

std::string seen_in_words(const std::vector<View>& views) {
  if (views.empty()) return {};
  std::vector<std::string> directions;
  for (const View& view : views) {
    std::ostringstream text;
    text.precision(3);
    text << '(' << view.direction.x() << ", " << view.direction.y() << ", " << view.direction.z()
         << ')';
    directions.push_back(text.str());
  }
  return "seen along " + core::listed(directions);
}

}  // namespace tencer::model
