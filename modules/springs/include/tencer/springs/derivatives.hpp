// How a cable's force changes with its stiffness k, its rest length l and the places s where it is
// attached, to second order (paper sections 4 and 5.3). E(d, k, l) is the energy of law.hpp.
#pragma once

#include <Eigen/Core>
#include <array>
#include <span>
#include <tencer/springs/cable.hpp>

namespace tencer::springs {

// d(force)/dk and d(force)/dl at span d; force as in law.hpp. Zero where slack. At d = 0 zero, for
// the direction is not defined there.
Eigen::Vector3d force_by_stiffness(const Cable& cable, const Eigen::Vector3d& d);
Eigen::Vector3d force_by_rest_length(const Cable& cable, const Eigen::Vector3d& d);

// d(weight)/ds of each share of `stencil` (the cable's own), s of the attachment a or b; zeros for
// an anchor. Weights are linear in s along an edge, so there is no second derivative; at a vertex
// the rates jump, and these are those of the edge that the stencil was made for.
enum class Attachment { a, b };
std::array<double, 4> weight_rates(const Cable& cable, const Stencil& stencil,
                                   std::span<const geometry::ArcLength> rods,
                                   Attachment attachment);

// Two directions in which a cable varies: d(a, b) = d + a span_1 + b span_2 + a b span_12,
// k(b) = k + b stiffness_2, l(b) = l + b rest_length_2. The first leaves k and l alone.
struct Variation {
  Eigen::Vector3d span_1 = Eigen::Vector3d::Zero();
  Eigen::Vector3d span_2 = Eigen::Vector3d::Zero();
  Eigen::Vector3d span_12 = Eigen::Vector3d::Zero();
  double stiffness_2 = 0.0;
  double rest_length_2 = 0.0;
};

// Derivatives at a = b = 0, along a variation, of the derivatives of E: with f = dE/dd, force_1 is
// df/da, force_2 is df/db, force_12 is d2f/da db, and by_stiffness_12 and by_rest_length_12 are
// d2/da db of dE/dk and dE/dl. All are zero where the cable is slack. At d = 0 they are those of
// k |d|^2 / 2 where the rest length is 0 and does not vary, otherwise zero.
struct Response {
  Eigen::Vector3d force_1 = Eigen::Vector3d::Zero();
  Eigen::Vector3d force_2 = Eigen::Vector3d::Zero();
  Eigen::Vector3d force_12 = Eigen::Vector3d::Zero();
  double by_stiffness_12 = 0.0;
  double by_rest_length_12 = 0.0;
};
Response respond(const Cable& cable, const Eigen::Vector3d& d, const Variation& variation);

}  // namespace tencer::springs
