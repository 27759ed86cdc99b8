#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <tencer/certify/stance.hpp>
#include <tencer/core/error.hpp>
#include <vector>

namespace tencer::certify {
namespace {

using Eigen::Vector3d;

struct Corner {
  Vector3d x = Vector3d::Zero();
  int vertex = -1;  // of all; -1: far out, to begin with
};
using Face = std::array<Corner, 3>;

// The shares of the corners in the point of their plane that is above or below `x`; far below 0
// when corners above a line leave no such point.
Vector3d shares(const Face& face, const Vector3d& x) {
  Eigen::Matrix3d rows;
  for (int k = 0; k < 3; ++k) rows.col(k) << face[k].x.head<2>(), 1.0;
  const Vector3d wanted(x.x(), x.y(), 1.0);
  const Vector3d found = rows.fullPivLu().solve(wanted);
  return (rows * found - wanted).norm() < 1e-6 ? found : Vector3d(Vector3d::Constant(-1e9));
}

// The face of the convex hull below the origin: of all triangles around it the one that is lowest
// there, a linear program, by the simplex method. Not set: the origin is not above the points.
std::optional<Face> face_below(const Eigen::Matrix3Xd& points) {
  constexpr int most_steps = 10000;
  const double reach = points.colwise().norm().maxCoeff();
  const double far = 10 * reach, high = 1e4 * reach;
  Face face{Corner{{far, -far, high}}, Corner{{-far, -far, high}}, Corner{{0, far, high}}};
  for (int step = 0; step < most_steps; ++step) {
    const Vector3d normal = (face[1].x - face[0].x).cross(face[2].x - face[0].x);
    const Vector3d up = normal.z() < 0 ? Vector3d(-normal) : normal;
    Eigen::Index lowest = 0;
    const double depth = (up.transpose() * (points.colwise() - face[0].x)).minCoeff(&lowest);
    if (depth >= -1e-9 * reach * up.norm()) break;
    const Vector3d now = shares(face, Vector3d::Zero());
    const Vector3d entering = shares(face, points.col(lowest));
    int leaves = -1;
    for (int k = 0; k < 3; ++k)
      if (entering[k] > 1e-12 &&
          (leaves < 0 || now[k] * entering[leaves] < now[leaves] * entering[k]))
        leaves = k;
    if (leaves < 0) return std::nullopt;
    face[leaves] = {points.col(lowest), static_cast<int>(lowest)};
  }
  for (const Corner& corner : face)
    if (corner.vertex < 0) return std::nullopt;
  return face;
}

// Turned so that `down` is along -z.
Eigen::Matrix3Xd levelled(const Eigen::Matrix3Xd& points, const Vector3d& down) {
  Eigen::Matrix3d turn;
  turn.row(0) = down.unitOrthogonal();
  turn.row(2) = -down.normalized();
  turn.row(1) = Vector3d(turn.row(2)).cross(Vector3d(turn.row(0)));
  return turn * points;
}

// The direction across the face's corners on the side of `down`; not set: they are on a line.
std::optional<Vector3d> across(const Eigen::Matrix3Xd& points, const Face& face,
                               const Vector3d& down) {
  const Vector3d a = points.col(face[0].vertex);
  const Vector3d b = points.col(face[1].vertex) - a;
  const Vector3d c = points.col(face[2].vertex) - a;
  const Vector3d normal = b.cross(c);
  if (normal.norm() <= 1e-9 * (b.squaredNorm() + c.squaredNorm())) return std::nullopt;
  const Vector3d unit = normal.normalized();
  return unit.dot(down) < 0 ? Vector3d(-unit) : unit;
}

// Of the points that touch the ground (level: none is below) the three between which the origin is
// best, each bearing part of the weight; when more touch, one of three may bear none. Not set: it
// tips over.
std::optional<std::array<Eigen::Index, 3>> feet_of(const Eigen::Matrix3Xd& level) {
  constexpr double well_within = 0.02;  // least part of the weight on each of three
  constexpr double touches = 1e-3;      // of the size: rods give way so far
  constexpr std::size_t most_tried = 40;
  const double reach = level.colwise().norm().maxCoeff();
  const double ground = level.row(2).minCoeff();
  std::vector<Eigen::Index> touching;
  for (Eigen::Index i = 0; i < level.cols(); ++i)
    if (level(2, i) - ground <= touches * reach) touching.push_back(i);
  std::vector<Eigen::Index> tried;
  const std::size_t some = std::min(most_tried, touching.size());
  for (std::size_t i = 0; i < some; ++i) tried.push_back(touching[i * touching.size() / some]);
  std::array<Eigen::Index, 3> best{};
  double most = -1;
  for (std::size_t i = 0; i < tried.size(); ++i)
    for (std::size_t j = i + 1; j < tried.size(); ++j)
      for (std::size_t k = j + 1; k < tried.size(); ++k) {
        const Face face{Corner{level.col(tried[i])}, Corner{level.col(tried[j])},
                        Corner{level.col(tried[k])}};
        const double least = shares(face, Vector3d::Zero()).minCoeff();
        if (!(least > most + 1e-9)) continue;
        most = least;
        best = {tried[i], tried[j], tried[k]};
      }
  const double needed = touching.size() > 3 ? -1e-9 : well_within;
  return most >= needed ? std::optional(best) : std::nullopt;
}

}  // namespace

Vector3d centre_of_mass(const model::Structure& structure, const model::State& state,
                        const Eigen::VectorXd& weight_per_length) {
  core::require(weight_per_length.size() == static_cast<Eigen::Index>(structure.rods.size()) &&
                    (weight_per_length.array() > 0).all() && weight_per_length.allFinite(),
                "centre_of_mass: needs a positive weight per length for every rod");
  Vector3d sum = Vector3d::Zero();
  double all = 0;
  for (std::size_t r = 0; r < state.size(); ++r) {
    const auto& x = state[r].x;
    const auto& lengths = structure.rods[r].rest_lengths;
    for (Eigen::Index j = 0; j < lengths.size(); ++j) {
      const double weight = weight_per_length[static_cast<Eigen::Index>(r)] * lengths[j];
      sum += weight * (x.col(j) + x.col((j + 1) % x.cols())) / 2;
      all += weight;
    }
  }
  return sum / all;
}

std::optional<Stance> stance(const model::Structure& structure, const model::State& state,
                             const Eigen::VectorXd& weight_per_length) {
  constexpr int most_rolls = 100;
  const Vector3d centre = centre_of_mass(structure, state, weight_per_length);
  std::vector<Support> vertices;
  Eigen::Index count = 0;
  for (const auto& rod : state) count += rod.x.cols();
  Eigen::Matrix3Xd points(3, count);
  for (int r = 0; r < static_cast<int>(state.size()); ++r)
    for (int v = 0; v < state[r].x.cols(); ++v) {
      points.col(static_cast<Eigen::Index>(vertices.size())) = state[r].x.col(v) - centre;
      vertices.push_back({r, v});
    }
  Vector3d down = -Vector3d::UnitZ();
  for (int roll = 0; roll < most_rolls; ++roll) {
    const auto face = face_below(levelled(points, down));
    if (!face) return std::nullopt;
    const auto next = across(points, *face, down);
    if (!next) return std::nullopt;
    down = *next;
    if (const auto feet = feet_of(levelled(points, down))) {
      Stance stance{.down = down};
      for (int k = 0; k < 3; ++k) stance.feet[k] = vertices[static_cast<std::size_t>((*feet)[k])];
      return stance;
    }
  }
  return std::nullopt;
}

}  // namespace tencer::certify
