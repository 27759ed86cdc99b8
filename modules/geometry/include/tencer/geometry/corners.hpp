// How a polyline turns, and where it does not look like a smooth curve.
#pragma once

#include <tencer/geometry/polyline.hpp>
#include <vector>

namespace tencer::geometry {

// The angles at its vertices, added up; radians.
double total_turning(const Polyline& curve);

struct Corner {
  int vertex = 0;
  double s = 0.0;      // arc length
  double angle = 0.0;  // by which the curve turns there, radians
};

// The vertices at which the curve turns by more than 45 degrees, or by more than 20 and four times
// as far as at their neighbours on average.
std::vector<Corner> corners(const Polyline& curve);

// Whether the curvature changes from one vertex to the next by more than it is large, corners that
// stand alone left out, as it does when points are measured or rounded. Not for curves of fewer
// than 12 vertices, nor where turns are below a degree.
bool is_rough(const Polyline& curve);

// The vertex at which the turn differs most from that at the vertex before, corners that stand
// alone left out, with this difference as its angle. For curves that are rough.
Corner roughest(const Polyline& curve);

}  // namespace tencer::geometry
