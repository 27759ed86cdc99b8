#include <Eigen/QR>
#include <limits>
#include <tencer/linalg/nonnegative.hpp>
#include <tencer/pipeline/surrounds.hpp>

namespace tencer::pipeline {
namespace {

// The distance of a point from the convex hull of the columns of `anchors`: the least
// |sum w_i d_i| over shares w_i >= 0 that add up to 1, d_i the spans from the point to the anchors
// in units of the longest. Any z >= 0 is such shares times their sum t, and |sum z_i d_i|^2 + (t -
// 1)^2 is at best D^2 / (1 + D^2), which grows with D = |sum w_i d_i|: its minimum over z >= 0 has
// the shares that are closest.
double distance_to_hull(const Eigen::MatrixXd& anchors, const Eigen::VectorXd& point) {
  const Eigen::Index dimension = anchors.rows();
  Eigen::MatrixXd columns(dimension + 1, anchors.cols());
  columns.topRows(dimension) = anchors.colwise() - point;
  const double reach = columns.topRows(dimension).colwise().norm().maxCoeff();
  columns.topRows(dimension) /= reach;
  columns.row(dimension).setOnes();

  linalg::NonnegativeProblem problem{.size = static_cast<int>(anchors.cols())};
  problem.slope = [&](std::span<const int> set, const Eigen::VectorXd& values,
                      Eigen::VectorXd& slope) {
    Eigen::VectorXd rest = Eigen::VectorXd::Unit(dimension + 1, dimension);
    for (std::size_t i = 0; i < set.size(); ++i)
      rest -= values[static_cast<Eigen::Index>(i)] * columns.col(set[i]);
    slope = columns.transpose() * rest;
  };
  problem.column = [&](std::span<const int> set, int j) {
    Eigen::VectorXd products(static_cast<Eigen::Index>(set.size()) + 1);
    for (std::size_t i = 0; i < set.size(); ++i)
      products[static_cast<Eigen::Index>(i)] = columns.col(set[i]).dot(columns.col(j));
    products[products.size() - 1] = columns.col(j).squaredNorm();
    return products;
  };
  // A slope of that leaves a distance of its root.
  const auto found = linalg::solve_nonnegative(problem, {.tolerance = 1e-15});
  const Eigen::VectorXd sum = columns(Eigen::all, found.set) * found.values;
  return reach * sum.head(dimension).norm() / sum[dimension];
}

}  // namespace

Outside furthest_outside(const Eigen::Matrix3Xd& anchors, const Eigen::Matrix3Xd& points,
                         bool planar) {
  constexpr double flat = 1e-9;
  constexpr double touching = 1e-6;
  const int dimension = planar ? 2 : 3;
  const Outside nothing_within{.point = 0, .distance = std::numeric_limits<double>::infinity()};
  if (anchors.cols() <= dimension) return nothing_within;
  const Eigen::MatrixXd corners = anchors.topRows(dimension);
  const Eigen::MatrixXd centred = corners.colwise() - corners.rowwise().mean();
  Eigen::ColPivHouseholderQR<Eigen::MatrixXd> extent(centred);
  extent.setThreshold(flat);
  if (extent.rank() < dimension) return nothing_within;

  const double size = (corners.rowwise().maxCoeff() - corners.rowwise().minCoeff()).norm();
  Outside worst;
  for (Eigen::Index i = 0; i < points.cols(); ++i) {
    const double distance = distance_to_hull(corners, points.col(i).head(dimension));
    if (distance > touching * size && distance > worst.distance)
      worst = {.point = static_cast<int>(i), .distance = distance};
  }
  return worst;
}

}  // namespace tencer::pipeline
