// Smooth curves through a few points.
#pragma once

#include <tencer/geometry/polyline.hpp>
#include <tencer/geometry/sampling.hpp>

namespace tencer::geometry {

// The cubic spline through the vertices of a polyline, twice continuously differentiable: periodic
// when the polyline is closed, otherwise with ends free of curvature. The parameter runs from 0 at
// vertex 0 along the chords, over [0, length of the polyline]. Throws std::invalid_argument for
// fewer than 3 (closed) or 2 vertices and for two neighbours in the same place. Time and memory
// grow with the vertices.
Curve spline(const Polyline& through);

// n points of the spline at equal arc length, the first at vertex 0; throws as spline and sample
// do.
Polyline sample_spline(const Polyline& through, int n);

}  // namespace tencer::geometry
