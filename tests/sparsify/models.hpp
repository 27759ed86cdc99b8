// Small models in scaled units: rods of total length 1, bending stiffness 1.
#pragma once

#include <cmath>
#include <tencer/curves/analytic.hpp>
#include <tencer/equilibrium/structure.hpp>
#include <tencer/sensitivity/target.hpp>
#include <tencer/sparsify/decimate.hpp>
#include <tencer/sparsify/dense.hpp>
#include <tencer/sparsify/rules.hpp>
#include <tencer/symmetry/detect.hpp>
#include <vector>

namespace tencer::sparsify::test {

struct Model {
  equilibrium::Structure structure{};
  std::vector<Eigen::Matrix3Xd> positions{};
};

inline Model make_model(std::vector<geometry::Polyline> curves) {
  double length = 0;
  for (const auto& curve : curves) length += geometry::edge_lengths(curve).sum();
  Model model;
  for (auto& curve : curves) {
    curve.points /= length;
    // A radius of 1/2000 of the length.
    model.structure.rods.push_back({.closed = curve.closed,
                                    .section = {.EA = 1.6e7, .EI1 = 1.0, .EI2 = 1.0, .GJ = 1.0},
                                    .rest_lengths = geometry::edge_lengths(curve)});
    model.positions.push_back(curve.points);
  }
  return model;
}

inline symmetry::Group group_of(const Model& model) {
  symmetry::Figure figure;
  for (std::size_t r = 0; r < model.structure.rods.size(); ++r) {
    const auto& rod = model.structure.rods[r];
    figure.curves.push_back({.points = model.positions[r], .closed = rod.closed});
    figure.rods.emplace_back(rod.rest_lengths, rod.closed);
    figure.classes.push_back(0);
  }
  return symmetry::detect(figure).group;
}

inline Model trefoil(int vertices = 60) {
  return make_model({curves::trefoil(curves::TrefoilForm::hypotrochoid, 1.0, vertices)});
}

// Two linked ellipses in perpendicular planes.
inline Model linked_ellipses(int vertices = 36) {
  auto curves = curves::borromean_ellipses(2.0, 1.0, vertices);
  curves.pop_back();
  curves[1].points.colwise() += Eigen::Vector3d(0.35, 0.2, 0.1);
  return make_model(curves);
}

// An open rod in a box whose corners are anchors.
inline Model hung_helix(int vertices = 40) {
  Model model = make_model({curves::helix(1.0, 0.7, 1.5, vertices)});
  const auto& x = model.positions[0];
  const Eigen::Vector3d low = x.rowwise().minCoeff();
  const Eigen::Vector3d high = x.rowwise().maxCoeff();
  const double margin = 0.1 * (high - low).norm();
  model.structure.anchors.resize(3, 8);
  for (int corner = 0; corner < 8; ++corner)
    for (int axis = 0; axis < 3; ++axis)
      model.structure.anchors(axis, corner) =
          (corner >> axis) & 1 ? high[axis] + margin : low[axis] - margin;
  return model;
}

inline Network dense_network(const Model& model, const Rules& rules = {}) {
  Network network{.structure = model.structure,
                  .state = equilibrium::make_state(model.structure, model.positions)};
  network.structure.cables =
      dense_springs(model.structure, model.positions,
                    candidates(model.structure, model.positions, rules).value());
  return network;
}

inline sensitivity::Target target_of(const Model& model, const Network& network) {
  return sensitivity::make_target(network.structure, model.positions);
}

// In the units of DecimateOptions::threshold.
inline double distance_per_vertex(const sensitivity::Target& target, const Network& network) {
  double length = 0;
  double vertices = 0;
  for (const auto& rod : network.structure.rods) {
    length += rod.length();
    vertices += rod.vertices();
  }
  return std::sqrt(sensitivity::deviation(target, network.state).value) / (vertices * length);
}

// The pruned network, decimated until it is `factor` times as far from the target.
inline Network decimated(const Model& model, double factor = 3.0, const Rules& rules = {}) {
  const Network dense = dense_network(model, rules);
  const auto target = target_of(model, dense);
  const Network pruned = prune(dense, target).network;
  return decimate(pruned, target, {.threshold = factor * distance_per_vertex(target, pruned)})
      .network;
}

inline double max_percent(const Model& model, const Network& network) {
  return sensitivity::deviation(target_of(model, network), network.state).max_percent;
}

inline int cables(const Network& network) {
  return static_cast<int>(network.structure.cables.size());
}

}  // namespace tencer::sparsify::test
