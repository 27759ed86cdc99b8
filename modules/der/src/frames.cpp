#include <cmath>
#include <numbers>
#include <tencer/core/error.hpp>
#include <tencer/der/energy.hpp>
#include <utility>

#include "framed.hpp"
#include "parallel_transport.hpp"

namespace tencer::der {
namespace {

Eigen::Vector3d tangent(const Rod& rod, const Eigen::Matrix3Xd& x, int j) {
  return edge(rod, x, j).normalized();
}

// Any unit vector perpendicular to t, the same for the same t.
Eigen::Vector3d perpendicular(const Eigen::Vector3d& t) {
  int axis = 0;
  t.cwiseAbs().minCoeff(&axis);
  return director(Eigen::Vector3d::Unit(axis), t);
}

double rest_twist(const Rod& rod, int b) {
  return rod.rest_twist.size() > 0 ? rod.rest_twist[b] : 0.0;
}

// The untwisted frames along x, and at the seam of a closed rod minus the holonomy in [-pi, pi].
ReferenceFrames bishop_frames(const Rod& rod, const Eigen::Matrix3Xd& x) {
  const int edges = rod.edges();
  ReferenceFrames frames{.tangent = Eigen::Matrix3Xd(3, edges),
                         .director = Eigen::Matrix3Xd(3, edges),
                         .twist = Eigen::VectorXd::Zero(rod.bending_vertices())};
  for (int j = 0; j < edges; ++j) {
    const Eigen::Vector3d t = tangent(rod, x, j);
    frames.tangent.col(j) = t;
    frames.director.col(j) =
        j == 0
            ? perpendicular(t)
            : director(parallel_transport(frames.director.col(j - 1), frames.tangent.col(j - 1), t),
                       t);
  }
  if (rod.closed) {
    const Eigen::Vector3d t = frames.tangent.col(0);
    const Eigen::Vector3d around =
        parallel_transport(frames.director.col(edges - 1), frames.tangent.col(edges - 1), t);
    frames.twist[0] = signed_angle(around, frames.director.col(0), t);
  }
  return frames;
}

// Theta along Bishop frames such that the twist beyond the rest twist, none unless a closing angle
// asks for it, is the same per length everywhere.
Eigen::VectorXd relaxed_theta(const Rod& rod, double seam_twist) {
  double excess = 0;
  if (rod.closing_angle) {
    excess = *rod.closing_angle + seam_twist;
    for (int b = 0; b < rod.bending_vertices(); ++b) excess -= rest_twist(rod, b);
  }
  Eigen::VectorXd theta = Eigen::VectorXd::Zero(rod.edges());
  const double per_length = excess / rod.length();
  for (int b = rod.closed ? 1 : 0; b < rod.bending_vertices(); ++b) {
    const Corner c = corner(rod, b);
    theta[c.edge_after] = theta[c.edge_before] + rest_twist(rod, b) + per_length * c.voronoi;
  }
  return theta;
}

// How the holonomy changes when a closed rod moves from x by `step`. A frame untwisted at x,
// carried along in time, gains twist at each vertex; summing these small angles, rather than
// comparing two holonomies, leaves no doubt about full turns.
double holonomy_change(const Rod& rod, const Eigen::Matrix3Xd& x,
                       const Eigen::Ref<const Eigen::VectorXd>& step) {
  const int edges = rod.edges();
  const auto moved_tangent = [&](int j) -> Eigen::Vector3d {
    return (edge(rod, x, j) + step.segment<3>(3 * next(rod, j)) - step.segment<3>(3 * j))
        .normalized();
  };
  Eigen::Vector3d t = tangent(rod, x, 0);
  Eigen::Vector3d t_moved = moved_tangent(0);
  Eigen::Vector3d d = perpendicular(t);
  Eigen::Vector3d d_moved = parallel_transport(d, t, t_moved);
  double change = 0;
  for (int j = 1; j <= edges; ++j) {
    const Eigen::Vector3d u = tangent(rod, x, j % edges);
    const Eigen::Vector3d u_moved = moved_tangent(j % edges);
    d = director(parallel_transport(d, t, u), u);
    const Eigen::Vector3d carried = parallel_transport(d_moved, t_moved, u_moved);
    d_moved = parallel_transport(d, u, u_moved);
    change -= signed_angle(carried, d_moved, u_moved);
    t = u;
    t_moved = u_moved;
  }
  return change;
}

void carry_frames(const Rod& rod, RodState& state) {
  ReferenceFrames& frames = state.frames;
  for (int j = 0; j < rod.edges(); ++j) {
    const Eigen::Vector3d t = tangent(rod, state.x, j);
    frames.director.col(j) =
        director(parallel_transport(frames.director.col(j), frames.tangent.col(j), t), t);
    frames.tangent.col(j) = t;
  }
  for (int b = 0; b < rod.bending_vertices(); ++b) {
    const Corner c = corner(rod, b);
    const Eigen::Vector3d u = frames.tangent.col(c.edge_after);
    const Eigen::Vector3d across = parallel_transport(frames.director.col(c.edge_before),
                                                      frames.tangent.col(c.edge_before), u);
    const double angle = signed_angle(across, frames.director.col(c.edge_after), u);
    frames.twist[b] += std::remainder(angle - frames.twist[b], 2 * std::numbers::pi);
  }
}

}  // namespace

RodState make_state(const Rod& rod, Eigen::Matrix3Xd x) {
  core::require(x.cols() == rod.vertices(), "make_state: needs one point per vertex");
  RodState state{.x = std::move(x)};
  switch (twist_model(rod)) {
    case TwistModel::none:
      break;
    case TwistModel::uniform:
      state.holonomy = -bishop_frames(rod, state.x).twist[0];
      break;
    case TwistModel::per_edge:
      state.frames = bishop_frames(rod, state.x);
      state.theta = relaxed_theta(rod, rod.closed ? state.frames.twist[0] : 0.0);
      break;
  }
  return state;
}

void displace(const Rod& rod, RodState& state, const Eigen::Ref<const Eigen::VectorXd>& step) {
  const int positions = 3 * rod.vertices();
  const TwistModel model = twist_model(rod);
  if (model == TwistModel::uniform) state.holonomy += holonomy_change(rod, state.x, step);
  state.x.reshaped() += step.head(positions);
  if (model == TwistModel::per_edge) {
    state.theta += step.tail(rod.edges());
    carry_frames(rod, state);
  }
}

Eigen::Matrix3d material_frame(const RodState& state, int edge) {
  core::require(edge >= 0 && edge < state.theta.size(),
                "material_frame: needs an edge of a rod with an angle per edge");
  const Eigen::Vector3d t = state.frames.tangent.col(edge);
  const auto frame = material_frame<double>(t, state.frames.director.col(edge), state.theta[edge]);
  Eigen::Matrix3d columns;
  columns << frame.m1, frame.m2, t;
  return columns;
}

void set_material_frame(RodState& state, int edge, const Eigen::Vector3d& m1) {
  const Eigen::Matrix3d frame = material_frame(state, edge);
  const Eigen::Vector2d across = frame.leftCols<2>().transpose() * m1;
  core::require(across.norm() > 1e-8 * m1.norm(),
                "set_material_frame: m1 must not be along the edge");
  state.theta[edge] += std::atan2(across[1], across[0]);
}

void set_rest_shape(Rod& rod, const Eigen::Matrix3Xd& x, const Eigen::Matrix3Xd& m1) {
  core::require(x.cols() == (rod.closed ? m1.cols() : m1.cols() + 1),
                "set_rest_shape: needs one point per vertex and one m1 per edge");
  rod.rest_lengths.resize(m1.cols());
  for (int j = 0; j < rod.edges(); ++j) rod.rest_lengths[j] = edge(rod, x, j).norm();
  rod.rest_curvature.resize(2, rod.bending_vertices());
  rod.rest_twist.resize(rod.bending_vertices());
  for (int b = 0; b < rod.bending_vertices(); ++b) {
    const Corner c = corner(rod, b);
    const Eigen::Vector3d t = tangent(rod, x, c.edge_before);
    const Eigen::Vector3d u = tangent(rod, x, c.edge_after);
    const Eigen::Vector3d before = director(m1.col(c.edge_before), t);
    const Eigen::Vector3d across = director(parallel_transport(before, t, u), u);
    const double twist = signed_angle(across, director(m1.col(c.edge_after), u), u);
    // kb lies along t x u, which transport leaves alone: its components may be taken at u.
    const auto halfway = material_frame<double>(u, across, twist / 2);
    const Eigen::Vector3d kb = t.cross(u) * (4 / (t + u).squaredNorm());
    rod.rest_curvature.col(b) << kb.dot(halfway.m2), -kb.dot(halfway.m1);
    rod.rest_twist[b] = twist;
  }
}

Eigen::VectorXd rotation_step(const Rod& rod, const RodState& state, const Eigen::Vector3d& omega) {
  Eigen::VectorXd step = Eigen::VectorXd::Zero(unknowns(rod));
  for (int i = 0; i < rod.vertices(); ++i)
    step.segment<3>(3 * i) = omega.cross(Eigen::Vector3d(state.x.col(i)));
  if (twist_model(rod) == TwistModel::per_edge)
    step.tail(rod.edges()) = state.frames.tangent.transpose() * omega;
  return step;
}

}  // namespace tencer::der
