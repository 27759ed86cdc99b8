#include <algorithm>
#include <tencer/model/frames.hpp>
#include <tencer/model/rest_shape.hpp>

namespace tencer::model {
namespace {

// Half of the edges beside each bending vertex.
Eigen::VectorXd voronoi_lengths(const der::Rod& rod) {
  Eigen::VectorXd lengths(rod.bending_vertices());
  for (int b = 0; b < rod.bending_vertices(); ++b) {
    const int after = rod.bending_vertex(b);
    const int before = (after + rod.edges() - 1) % rod.edges();
    lengths[b] = (rod.rest_lengths[before] + rod.rest_lengths[after]) / 2;
  }
  return lengths;
}

// Where the bending vertices are, as fractions of the length.
Eigen::VectorXd fractions(const der::Rod& rod) {
  Eigen::VectorXd at(rod.bending_vertices());
  double s = 0;
  for (int j = 0, b = 0; j < rod.edges(); s += rod.rest_lengths[j++])
    if (b < at.size() && rod.bending_vertex(b) == j) at[b++] = s / rod.length();
  return at;
}

// `values` (a column for each of `from`, increasing) at the fractions `to`; beyond the ends of an
// open rod as at the ends, on a closed one around the seam.
Eigen::MatrixXd interpolated(const Eigen::MatrixXd& values, const Eigen::VectorXd& from,
                             const Eigen::VectorXd& to, bool closed) {
  const Eigen::Index last = from.size() - 1;
  Eigen::MatrixXd result(values.rows(), to.size());
  for (Eigen::Index k = 0; k < to.size(); ++k) {
    const Eigen::Index above = std::upper_bound(from.begin(), from.end(), to[k]) - from.begin();
    if (above > last || above == 0) {
      const double t = closed ? (to[k] - from[last]) / (1 + from[0] - from[last]) : 0.0;
      const Eigen::Index nearest = above == 0 ? 0 : last;
      result.col(k) = closed ? Eigen::VectorXd((1 - t) * values.col(last) + t * values.col(0))
                             : Eigen::VectorXd(values.col(nearest));
      continue;
    }
    const double t = (to[k] - from[above - 1]) / (from[above] - from[above - 1]);
    result.col(k) = (1 - t) * values.col(above - 1) + t * values.col(above);
  }
  return result;
}

// A rod that rests along the curve, its first axis carried along without twist (on a closed curve
// with the least even twist that closes it).
der::Rod rod_along(const geometry::Polyline& curve,
                   const std::optional<Eigen::Vector3d>& director) {
  der::Rod rod{.closed = curve.closed,
               .section = {.EI2 = 2.0},  // two axes, so that the rod has frames
               .rest_lengths = geometry::edge_lengths(curve)};
  if (curve.closed) rod.closing_angle = 0.0;
  der::RodState state = der::make_state(rod, curve.points);
  if (director) turn_frames(state, *director);
  der::set_rest_shape(rod, curve.points, directors(state));
  if (!curve.closed) rod.rest_twist.resize(0);
  return rod;
}

}  // namespace

void copy_rest_shape(const der::Rod& from, der::Rod& rod) {
  if (from.bending_vertices() == 0 || rod.bending_vertices() == 0) return;
  const Eigen::VectorXd lengths = voronoi_lengths(from);
  const Eigen::VectorXd at = fractions(from);
  const Eigen::VectorXd to = fractions(rod);
  const Eigen::VectorXd shares = voronoi_lengths(rod) * (from.length() / rod.length());
  const auto copy = [&](const Eigen::MatrixXd& bends) -> Eigen::MatrixXd {
    const Eigen::MatrixXd per_length = bends * lengths.cwiseInverse().asDiagonal();
    return interpolated(per_length, at, to, from.closed) * shares.asDiagonal();
  };
  if (from.rest_curvature.size() > 0) rod.rest_curvature = copy(from.rest_curvature);
  if (from.rest_twist.size() > 0) rod.rest_twist = copy(from.rest_twist.transpose()).transpose();
}

void set_rest_shape(const RestShape& shape, der::Rod& rod) {
  if (shape.curve) {
    copy_rest_shape(rod_along(*shape.curve, shape.director), rod);
  } else if (shape.curvature != 0) {
    // Bent by an angle a at a vertex, the curvature binormal is 2 tan(a / 2) long; along m2 when
    // the rod bends towards m1.
    rod.rest_curvature = Eigen::Matrix2Xd::Zero(2, rod.bending_vertices());
    rod.rest_curvature.row(0) =
        2 * (shape.curvature * voronoi_lengths(rod) / 2).array().tan().transpose();
  }
}

}  // namespace tencer::model
