#include "export/tube.hpp"

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

namespace tencer::io {
namespace {

using Eigen::Vector3d;

Vector3d tangent_at(const geometry::Polyline& line, int i) {
  const int n = line.vertices();
  const int before = line.closed ? (i + n - 1) % n : std::max(i - 1, 0);
  const int after = line.closed ? (i + 1) % n : std::min(i + 1, n - 1);
  return (line.points.col(after) - line.points.col(before)).normalized();
}

Vector3d across(const Vector3d& direction, const Vector3d& tangent) {
  return (direction - direction.dot(tangent) * tangent).normalized();
}

struct Ring {
  Vector3d centre;
  Vector3d tangent;
  Vector3d first;  // the outline's axes
  Vector3d second;
};

// One a vertex, and on a closed line the first again at the end, turned as the one before it.
std::vector<Ring> rings_of(const geometry::Polyline& line, const Eigen::Matrix3Xd& axes) {
  const int n = line.vertices();
  std::vector<Ring> rings;
  for (int k = 0; k < n + (line.closed ? 1 : 0); ++k) {
    const int i = k % n;
    const Vector3d tangent = tangent_at(line, i);
    Vector3d first = axes.cols() > 0 ? Vector3d(axes.col(i))
                     : rings.empty() ? tangent.unitOrthogonal()
                                     : rings.back().first;
    if (!rings.empty() && first.dot(rings.back().first) < 0) first = -first;
    first = across(first, tangent);
    rings.push_back({line.points.col(i), tangent, first, tangent.cross(first)});
  }
  return rings;
}

void add_triangle(Mesh& mesh, std::size_t a, std::size_t b, std::size_t c) {
  for (const std::size_t corner : {a, b, c})
    mesh.corners.push_back(static_cast<std::uint32_t>(corner));
}

void add_ring(Mesh& mesh, const Ring& ring, const Outline& outline) {
  for (Eigen::Index i = 0; i < outline.points.cols(); ++i) {
    const auto in_space = [&](const Eigen::Vector2d& at) -> Vector3d {
      return at.x() * ring.first + at.y() * ring.second;
    };
    mesh.points.emplace_back(ring.centre + in_space(outline.points.col(i)));
    mesh.normals.push_back(in_space(outline.normals.col(i)));
  }
}

void add_end(Mesh& mesh, const Ring& ring, const Outline& outline, bool forward) {
  const std::size_t from = mesh.points.size();
  const auto n = static_cast<std::size_t>(outline.points.cols());
  add_ring(mesh, ring, outline);
  for (std::size_t i = from; i < mesh.points.size(); ++i)
    mesh.normals[i] = forward ? ring.tangent : Vector3d(-ring.tangent);
  for (std::size_t i = 1; i + 1 < n; ++i)
    add_triangle(mesh, from, from + (forward ? i : i + 1), from + (forward ? i + 1 : i));
}

}  // namespace

Outline round_outline(double radius) {
  constexpr int sides = 12;
  Outline outline{Eigen::Matrix2Xd(2, sides), Eigen::Matrix2Xd(2, sides)};
  for (int i = 0; i < sides; ++i) {
    const double angle = 2 * std::numbers::pi * i / sides;
    outline.normals.col(i) << std::cos(angle), std::sin(angle);
  }
  outline.points = radius * outline.normals;
  return outline;
}

Outline rectangle_outline(double width, double height) {
  Outline outline{Eigen::Matrix2Xd(2, 8), Eigen::Matrix2Xd(2, 8)};
  outline.points << 1, 1, 1, -1, -1, -1, -1, 1,  //
      -1, 1, 1, 1, 1, -1, -1, -1;
  outline.normals << 1, 1, 0, 0, -1, -1, 0, 0,  //
      0, 0, 1, 1, 0, 0, -1, -1;
  outline.points.row(0) *= width / 2;
  outline.points.row(1) *= height / 2;
  return outline;
}

Mesh tube(const geometry::Polyline& line, const Outline& outline, const Eigen::Matrix3Xd& axes) {
  const std::vector<Ring> rings = rings_of(line, axes);
  const auto n = static_cast<std::size_t>(outline.points.cols());
  Mesh mesh;
  for (const Ring& ring : rings) add_ring(mesh, ring, outline);
  for (std::size_t r = 0; r + 1 < rings.size(); ++r)
    for (std::size_t i = 0; i < n; ++i) {
      const std::size_t here = r * n;
      const std::size_t next = (i + 1) % n;
      add_triangle(mesh, here + i, here + next, here + n + i);
      add_triangle(mesh, here + next, here + n + next, here + n + i);
    }
  if (!line.closed) {
    add_end(mesh, rings.front(), outline, false);
    add_end(mesh, rings.back(), outline, true);
  }
  return mesh;
}

Mesh cube(const Vector3d& centre, double side) {
  geometry::Polyline line{Eigen::Matrix3Xd(3, 2), false};
  line.points << centre - side / 2 * Vector3d::UnitZ(), centre + side / 2 * Vector3d::UnitZ();
  const Eigen::Matrix3Xd axes = Vector3d::UnitX().replicate(1, 2);
  return tube(line, rectangle_outline(side, side), axes);
}

}  // namespace tencer::io
