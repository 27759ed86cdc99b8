#include <tencer/core/error.hpp>
#include <tencer/symmetry/figure.hpp>

namespace tencer::symmetry {

void validate(const Figure& figure) {
  core::require(!figure.curves.empty(), "figure: needs at least one rod");
  core::require(figure.rods.size() == figure.curves.size(),
                "figure: needs one arc length for each curve");
  core::require(figure.classes.empty() || figure.classes.size() == figure.curves.size(),
                "figure: needs one class for each curve, or none at all");
  for (std::size_t r = 0; r < figure.curves.size(); ++r) {
    core::require(figure.rods[r].edges() == figure.curves[r].edges() &&
                      figure.rods[r].closed() == figure.curves[r].closed,
                  "figure: an arc length belongs to another curve");
    core::require(figure.curves[r].points.allFinite(), "figure: points must be finite");
  }
  core::require(figure.anchors.allFinite(), "figure: anchors must be finite");
}

Eigen::Vector3d centroid(const Figure& figure) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  double length = 0;
  for (const auto& curve : figure.curves) {
    const Eigen::VectorXd edges = geometry::edge_lengths(curve);
    for (Eigen::Index i = 0; i < edges.size(); ++i)
      sum += edges[i] / 2 * (curve.points.col(i) + curve.points.col((i + 1) % curve.points.cols()));
    length += edges.sum();
  }
  const Eigen::Vector3d middle = sum / length;
  return (middle.array().abs() > 1e-12 * length).select(middle, 0);
}

}  // namespace tencer::symmetry
