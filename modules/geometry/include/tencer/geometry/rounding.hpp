// Curves whose bends are no sharper than what a rod takes.
#pragma once

#include <optional>
#include <tencer/geometry/corners.hpp>
#include <tencer/geometry/polyline.hpp>
#include <vector>

namespace tencer::geometry {

struct Rounded {
  // As it was but for the bends, which have many vertices. A closed one starts where it was nearest
  // to its first vertex.
  Polyline curve{};
  // Where the given curve was sharper: the sharpest vertex of each place, and the angle by which
  // the curve turns in all of it.
  std::vector<Corner> bends{};
  double largest_move = 0.0;  // of a vertex from the new curve
  // The bend for which the curve has no room; then `curve` is the one given.
  std::optional<Corner> no_room{};
};

// Corners (corners.hpp), and stretches that bend to a smaller radius than this, become smooth bends
// of about this radius or a larger one, as short as that allows. Bends that would meet become one.
// Throws std::invalid_argument unless all edges have a positive finite length and radius > 0.
Rounded rounded(const Polyline& curve, double radius);

}  // namespace tencer::geometry
