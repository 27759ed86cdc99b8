// Polylines as smooth as the curves they stand for, for drawings.
#pragma once

#include <tencer/geometry/polyline.hpp>

namespace tencer::geometry {

// Every edge in `pieces`, with points on cubics that go through the vertices without a kink, but
// for corners (corners.hpp), which stay. Vertex i of the curve is vertex i * pieces of the result.
// Throws std::invalid_argument unless all edges have a positive finite length and pieces >= 1.
Polyline smoothed(const Polyline& curve, int pieces);

}  // namespace tencer::geometry
