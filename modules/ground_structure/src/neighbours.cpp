#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <tencer/ground_structure/neighbours.hpp>
#include <variant>

namespace tencer::ground_structure {
namespace {

double distance(const Eigen::Matrix3Xd& a, const Eigen::Matrix3Xd& b) {
  double squared = std::numeric_limits<double>::infinity();
  for (Eigen::Index i = 0; i < a.cols(); ++i)
    squared = std::min(squared, (b.colwise() - a.col(i)).colwise().squaredNorm().minCoeff());
  return std::sqrt(squared);
}

}  // namespace

std::set<std::pair<int, int>> relative_neighbours(const std::vector<Eigen::Matrix3Xd>& points) {
  const int count = static_cast<int>(points.size());
  Eigen::MatrixXd apart = Eigen::MatrixXd::Zero(count, count);
  for (int a = 0; a < count; ++a)
    for (int b = a + 1; b < count; ++b) apart(a, b) = apart(b, a) = distance(points[a], points[b]);
  std::set<std::pair<int, int>> pairs;
  for (int a = 0; a < count; ++a)
    for (int b = a + 1; b < count; ++b) {
      bool between = false;
      for (int c = 0; c < count && !between; ++c)
        between = c != a && c != b && std::max(apart(a, c), apart(b, c)) < apart(a, b);
      if (!between) pairs.emplace(a, b);
    }
  return pairs;
}

std::vector<springs::Cable> among_neighbours(std::span<const springs::Cable> cables,
                                             const std::vector<Eigen::Matrix3Xd>& points) {
  const auto pairs = relative_neighbours(points);
  std::vector<springs::Cable> result;
  std::ranges::copy_if(cables, std::back_inserter(result), [&](const springs::Cable& cable) {
    const auto* a = std::get_if<springs::OnRod>(&cable.a);
    const auto* b = std::get_if<springs::OnRod>(&cable.b);
    return !a || !b || a->rod == b->rod || pairs.contains(std::minmax(a->rod, b->rod));
  });
  return result;
}

}  // namespace tencer::ground_structure
