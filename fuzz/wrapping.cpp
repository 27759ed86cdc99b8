// Closed rods: going round any number of times leads to the same place, in the curve and in a cable
// attached there.
#include <limits>
#include <tencer/springs/cable.hpp>
#include <vector>

#include "bytes.hpp"
#include "must.hpp"

using namespace tencer;
using fuzz::must;

namespace {

// The end a of a cable at s on a rod whose vertices are numbers.
double place(const std::vector<geometry::ArcLength>& rods, const Eigen::VectorXd& x, double s,
             geometry::Side side) {
  const springs::Cable cable{.a = springs::OnRod{0, s}, .b = springs::AtAnchor{0}};
  const auto stencil = springs::stencil(cable, rods, Eigen::Vector3d::Zero(), side);
  double sum = 0, weights = 0;
  must(stencil.count == 2);
  for (int i = 0; i < stencil.count; ++i) {
    const springs::Share& share = stencil.shares[i];
    must(share.rod == 0 && share.vertex >= 0 && share.vertex < x.size());
    must(share.weight <= 0 && share.weight >= -1);
    weights += share.weight;
    sum += share.weight * x[share.vertex];
  }
  must(std::abs(weights + 1) <= 1e-15);
  return -sum;
}

}  // namespace

// Input: a byte for the edges, a double s, whole turns in two bytes and as
// a power of two in one, then two bytes an edge length
// and two a vertex.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  fuzz::Bytes bytes(data, size);
  const int edges = 3 + bytes.below_or(29);
  const double s = bytes.any_double();
  const double turns = std::round(1000 * bytes.share());
  const int doublings = bytes.below_or(40);
  if (!std::isfinite(s)) return 0;
  Eigen::VectorXd lengths(edges), x(edges);
  for (int i = 0; i < edges; ++i) {
    lengths[i] = bytes.scale(10) * (1.5 + 0.5 * bytes.share());
    x[i] = bytes.share();
  }
  const std::vector<geometry::ArcLength> rods{{lengths, true}};
  const geometry::ArcLength& rod = rods[0];
  const double length = rod.length();

  const double wrapped = rod.wrap(s);
  must(wrapped >= 0 && wrapped < length);
  must(rod.wrap(wrapped) == wrapped);
  for (const auto side : {geometry::Side::after, geometry::Side::before}) {
    must(place(rods, x, s, side) == place(rods, x, wrapped, side));
    // So many turns are exact in doubles.
    must(place(rods, x, std::ldexp(length, doublings), side) == x[0]);
    must(place(rods, x, -std::ldexp(length, doublings), side) == x[0]);
  }
  // Turns added in doubles are off by the rounding of the sum, as far as that moves the place.
  const double round = s + turns * length;
  if (!std::isfinite(round)) return 0;
  const double rounding =
      4 * std::numeric_limits<double>::epsilon() * (std::abs(s) + (std::abs(turns) + 1) * length);
  const double apart = std::abs(rod.wrap(round) - wrapped);
  must(std::min(apart, length - apart) <= rounding);
  const double steepest = 2 / lengths.minCoeff();
  const double moved = std::abs(place(rods, x, round, geometry::Side::after) -
                                place(rods, x, s, geometry::Side::after));
  must(moved <= steepest * rounding + 1e-14);
  return 0;
}
