// An attachment that slides along a closed rod, across vertices and the seam: its place is
// continuous, and moves as the rates of its weights say.
#include <limits>
#include <tencer/springs/derivatives.hpp>
#include <vector>

#include "bytes.hpp"
#include "must.hpp"

using namespace tencer;
using fuzz::must;

// Input: a byte for the edges, a byte for a vertex, a double for the step from it, then an edge
// length and three coordinates each.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  fuzz::Bytes bytes(data, size);
  const int edges = 3 + bytes.below_or(13);
  const int vertex = bytes.below_or(edges);  // edges: the seam from below
  const double wish = bytes.any_double();
  Eigen::VectorXd lengths(edges);
  Eigen::Matrix3Xd x(3, edges);
  for (int i = 0; i < edges; ++i) {
    lengths[i] = bytes.scale(8) * (1.5 + 0.5 * bytes.share());
    for (int axis = 0; axis < 3; ++axis) x(axis, i) = bytes.share();
  }
  if (!std::isfinite(wish)) return 0;
  const std::vector<geometry::ArcLength> rods{{lengths, true}};
  const geometry::ArcLength& rod = rods[0];
  // At most to the middle of the shortest edge.
  const double step = std::fmod(std::abs(wish), 0.5 * lengths.minCoeff());
  const double s = rod.knots()[vertex];
  const Eigen::Vector3d anchor(0.1, 0.2, 0.3);
  const auto cable = [&](double at) {
    return springs::Cable{.a = springs::OnRod{0, at}, .b = springs::AtAnchor{0}};
  };
  const auto span = [&](const springs::Stencil& stencil) {
    return springs::span_of(stencil, [&](int, int i) -> Eigen::Vector3d { return x.col(i); });
  };
  const Eigen::Vector3d at_vertex = anchor - x.col(vertex % edges);
  const double rounding = 16 * std::numeric_limits<double>::epsilon();
  for (const auto side : {geometry::Side::after, geometry::Side::before}) {
    const double way = side == geometry::Side::after ? step : -step;
    const springs::Stencil there = springs::stencil(cable(s), rods, anchor, side);
    must((span(there) - at_vertex).norm() <= rounding);
    const auto rates = springs::weight_rates(cable(s), there, rods, springs::Attachment::a);
    Eigen::Vector3d rate = Eigen::Vector3d::Zero();
    for (int i = 0; i < there.count; ++i) rate += rates[i] * x.col(there.shares[i].vertex);
    // Moved within the edge, to which the place is linear; s itself is rounded.
    const springs::Stencil moved = springs::stencil(cable(s + way), rods, anchor, side);
    const double gone = (s + way) - s;
    const double slack = rounding * (1 + rate.norm() * rod.length());
    must((span(moved) - at_vertex - gone * rate).norm() <= slack);
  }
  // From one side of the vertex to the other by 2 step: no further than both edges allow.
  const auto before = springs::stencil(cable(s - step), rods, anchor);
  const auto after = springs::stencil(cable(s + step), rods, anchor);
  const double steepest = 2 * std::sqrt(3.0) / lengths.minCoeff();
  must((span(before) - span(after)).norm() <=
       steepest * (2 * step + rounding * rod.length()) + rounding);
  return 0;
}
