// Roomy embeddings: a closed curve pushes itself apart until it is smooth and keeps clear of
// itself, and stays the same knot on the way.
#pragma once

#include <tencer/geometry/polyline.hpp>

namespace tencer::curves {

struct RepelOptions {
  int max_iterations = 2000;
  // Ends when the energy falls by less than this part in `patience` steps.
  double min_decrease = 1e-5;
  int patience = 20;

  // Throws std::invalid_argument naming the option that is wrong.
  void validate() const;
};

struct [[nodiscard]] Repelled {
  geometry::Polyline curve{};  // length 1, evenly spaced, centred at the origin
  double energy = 0.0;
  int iterations = 0;
  bool converged = false;  // false: the limit of iterations was met
};

// Descends the tangent-point energy of a closed curve of n >= 8 vertices, along quasi-Newton
// directions in the fractional Sobolev metric of "Repulsive curves", which is diagonal in the
// discrete Fourier basis of evenly spaced vertices. No step takes a vertex further than half the
// least distance of two edges that do not meet, so strands never pass through each other. Throws
// std::invalid_argument for an open curve, fewer vertices and a curve that, resampled at n points,
// crosses itself. Time: n^2 an iteration. (Yu, Schumacher, Crane, "Repulsive curves", 2021.)
Repelled repel(const geometry::Polyline& curve, const RepelOptions& options = {});

}  // namespace tencer::curves
