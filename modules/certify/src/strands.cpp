#include <algorithm>
#include <tencer/certify/strands.hpp>
#include <tencer/geometry/measure.hpp>

namespace tencer::certify {
namespace {

struct EdgeVertices {
  int rod = 0;
  int a = 0;  // its vertices
  int b = 0;
};

}  // namespace

bool strands_meet(const model::Structure& structure, const std::vector<Eigen::Matrix3Xd>& from,
                  const std::vector<Eigen::Matrix3Xd>& to) {
  constexpr int steps = 16;
  std::vector<EdgeVertices> edges;
  for (int r = 0; r < static_cast<int>(from.size()); ++r)
    for (int j = 0; j < structure.rods[r].edges(); ++j)
      edges.push_back({r, j, (j + 1) % structure.rods[r].vertices()});
  const auto move = [&](int rod, int v) -> Eigen::Vector3d {
    return to[rod].col(v) - from[rod].col(v);
  };
  const auto relative = [&](const EdgeVertices& one, const EdgeVertices& other) {
    double largest = 0;
    for (const int v : {one.a, one.b})
      for (const int w : {other.a, other.b})
        largest = std::max(largest, (move(one.rod, v) - move(other.rod, w)).norm());
    return largest;
  };
  const auto distance = [&](const EdgeVertices& one, const EdgeVertices& other, double t) {
    const auto at = [&](int rod, int v) -> Eigen::Vector3d {
      return (1 - t) * from[rod].col(v) + t * to[rod].col(v);
    };
    return geometry::segment_approach(at(one.rod, one.a), at(one.rod, one.b),
                                      at(other.rod, other.a), at(other.rod, other.b))
        .distance;
  };
  for (std::size_t i = 0; i < edges.size(); ++i)
    for (std::size_t j = i + 1; j < edges.size(); ++j) {
      const EdgeVertices& one = edges[i];
      const EdgeVertices& other = edges[j];
      const bool neighbours = one.rod == other.rod && (one.a == other.b || one.b == other.a);
      if (neighbours) continue;
      const double against = relative(one, other);
      if (distance(one, other, 0) > against) continue;
      for (int k = 0; k <= steps; ++k)
        if (distance(one, other, static_cast<double>(k) / steps) < against / steps) return true;
    }
  return false;
}

}  // namespace tencer::certify
