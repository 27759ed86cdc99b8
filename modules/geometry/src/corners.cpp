#include <Eigen/Geometry>
#include <cmath>
#include <numbers>
#include <tencer/geometry/corners.hpp>

namespace tencer::geometry {
namespace {

constexpr double degree = std::numbers::pi / 180;

// Per bending vertex (all of a closed curve, the inner ones of an open one): the axis about which
// the curve turns there, as long as twice the tangent of half the angle.
Eigen::Matrix3Xd turns(const Polyline& curve) {
  const Eigen::Matrix3Xd tangents = edge_vectors(curve).colwise().normalized();
  const int edges = curve.edges();
  Eigen::Matrix3Xd result(3, curve.closed ? edges : edges - 1);
  for (int b = 0; b < result.cols(); ++b) {
    const Eigen::Vector3d before = tangents.col(curve.closed ? (b + edges - 1) % edges : b);
    const Eigen::Vector3d after = tangents.col(curve.closed ? b : b + 1);
    result.col(b) = 2 * before.cross(after) / (1 + before.dot(after));
  }
  return result;
}

double angle_of(const Eigen::Vector3d& turn) { return 2 * std::atan(turn.norm() / 2); }

// Whether the curve turns much further at bending vertex b than at its neighbours.
bool stands_alone(const Eigen::Matrix3Xd& turns, bool closed, Eigen::Index b) {
  constexpr double far = 4;
  const Eigen::Index count = turns.cols();
  double sum = 0;
  int neighbours = 0;
  for (const Eigen::Index step : {count - 1, Eigen::Index(1)}) {
    const Eigen::Index at = (b + step) % count;
    if (at == b || (!closed && std::abs(at - b) != 1)) continue;
    sum += angle_of(turns.col(at));
    ++neighbours;
  }
  return neighbours > 0 && angle_of(turns.col(b)) * neighbours > far * sum;
}

// Calls visit(before, b) for neighbouring bending vertices, corners that stand alone left out.
template <class Visit>
void for_each_pair(const Eigen::Matrix3Xd& turns, bool closed, Visit&& visit) {
  for (Eigen::Index b = closed ? 0 : 1; b < turns.cols(); ++b) {
    const Eigen::Index before = (b + turns.cols() - 1) % turns.cols();
    if (!stands_alone(turns, closed, b) && !stands_alone(turns, closed, before)) visit(before, b);
  }
}

}  // namespace

double total_turning(const Polyline& curve) {
  const Eigen::Matrix3Xd turn = turns(curve);
  double sum = 0;
  for (Eigen::Index b = 0; b < turn.cols(); ++b) sum += angle_of(turn.col(b));
  return sum;
}

std::vector<Corner> corners(const Polyline& curve) {
  constexpr double sharp = 45 * degree;
  constexpr double visible = 20 * degree;
  const Eigen::Matrix3Xd turn = turns(curve);
  const Eigen::VectorXd lengths = edge_lengths(curve);
  std::vector<Corner> found;
  for (Eigen::Index b = 0; b < turn.cols(); ++b) {
    const double angle = angle_of(turn.col(b));
    if (angle <= visible || (angle <= sharp && !stands_alone(turn, curve.closed, b))) continue;
    const int vertex = static_cast<int>(curve.closed ? b : b + 1);
    found.push_back({.vertex = vertex, .s = lengths.head(vertex).sum(), .angle = angle});
  }
  return found;
}

bool is_rough(const Polyline& curve) {
  constexpr int few = 12;
  constexpr double slight = 1 * degree;
  if (curve.vertices() < few) return false;
  double squares = 0;
  double changes = 0;
  int pairs = 0;
  const Eigen::Matrix3Xd turn = turns(curve);
  for_each_pair(turn, curve.closed, [&](Eigen::Index before, Eigen::Index b) {
    squares += (turn.col(b).squaredNorm() + turn.col(before).squaredNorm()) / 2;
    changes += (turn.col(b) - turn.col(before)).squaredNorm();
    ++pairs;
  });
  return squares > slight * slight * pairs && changes > squares;
}

Corner roughest(const Polyline& curve) {
  Corner worst;
  const Eigen::Matrix3Xd turn = turns(curve);
  for_each_pair(turn, curve.closed, [&](Eigen::Index before, Eigen::Index b) {
    const double angle = angle_of(turn.col(b) - turn.col(before));
    if (angle <= worst.angle) return;
    worst.vertex = static_cast<int>(curve.closed ? b : b + 1);
    worst.angle = angle;
  });
  worst.s = edge_lengths(curve).head(worst.vertex).sum();
  return worst;
}

}  // namespace tencer::geometry
