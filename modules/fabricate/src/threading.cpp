#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <tencer/fabricate/crossings.hpp>
#include <tencer/fabricate/threading.hpp>

#include "alexander.hpp"

namespace tencer::fabricate {
namespace {

// Directions that no shape has a reason to be special in.
Eigen::Matrix3d view_number(int i) {
  return (Eigen::AngleAxisd(0.7123 + 1.131 * i, Eigen::Vector3d::UnitX()) *
          Eigen::AngleAxisd(1.2347 + 0.773 * i, Eigen::Vector3d::UnitY()) *
          Eigen::AngleAxisd(0.3719 + 0.417 * i, Eigen::Vector3d::UnitZ()))
      .toRotationMatrix();
}

// Whether no crossing is so near a vertex that rounding may have taken it for none or for two.
bool clear_of_vertices(const std::vector<Crossing>& found) {
  constexpr double near = 1e-9;
  const auto inside = [](const geometry::EdgePoint& at) { return at.t > near && at.t < 1 - near; };
  return std::ranges::all_of(found,
                             [&](const Crossing& c) { return inside(c.over) && inside(c.under); });
}

// The crossings in one view in which none is at a vertex, of those tried the one with the fewest.
std::vector<Crossing> simplest(std::span<const geometry::Polyline> curves) {
  constexpr int views = 12;
  std::optional<std::vector<Crossing>> best;
  for (int i = 0; i < views; ++i) {
    auto found = crossings(curves, view_number(i));
    if (clear_of_vertices(found) && (!best || found.size() < best->size())) best = std::move(found);
  }
  return best.value_or(std::vector<Crossing>());
}

int linking_number(const geometry::Polyline& a, const geometry::Polyline& b) {
  int sum = 0;
  for (const Crossing& c : simplest(std::array{a, b}))
    if (c.over.rod != c.under.rod) sum += c.sine > 0 ? 1 : -1;
  return sum / 2;
}

// Whether a plane lies between the two, by directions spread evenly over a half-sphere.
bool beside_each_other(const geometry::Polyline& a, const geometry::Polyline& b) {
  constexpr int directions = 400;
  constexpr double golden_angle = 2.399963229728653;
  for (int i = 0; i < directions; ++i) {
    const double z = (i + 0.5) / directions;
    const double r = std::sqrt(1 - z * z);
    const Eigen::RowVector3d normal(r * std::cos(golden_angle * i), r * std::sin(golden_angle * i),
                                    z);
    const Eigen::RowVectorXd along_a = normal * a.points;
    const Eigen::RowVectorXd along_b = normal * b.points;
    if (along_a.maxCoeff() < along_b.minCoeff() || along_b.maxCoeff() < along_a.minCoeff())
      return true;
  }
  return false;
}

}  // namespace

Threading threading(std::span<const geometry::Polyline> rods) {
  Threading result;
  for (int b = 0; b < static_cast<int>(rods.size()); ++b) {
    result.knotted.push_back(rods[b].closed && knotted(simplest(rods.subspan(b, 1))));
    for (int a = 0; a < b && rods[b].closed; ++a)
      if (rods[a].closed && !beside_each_other(rods[a], rods[b]))
        result.pairs.push_back({a, b, linking_number(rods[a], rods[b])});
  }
  return result;
}

}  // namespace tencer::fabricate
