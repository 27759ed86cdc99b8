#include <cmath>
#include <tencer/core/error.hpp>
#include <tencer/der/energy.hpp>

#include "framed_rod.hpp"
#include "hyper_dual.hpp"
#include "reduced.hpp"
#include "uniform_twist.hpp"

namespace tencer::der {
namespace {

using HyperVector = Vector3<HyperDual>;

HyperVector constant(const Eigen::Vector3d& x) {
  return hyper_dual_vector(x, Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero());
}

// One edge of a per-edge rod on its way along a v + b w.
struct MovingEdge {
  Eigen::Vector3d start_tangent;
  HyperVector tangent, director;
  HyperDual length, theta;
};

// How the angle of a director carried straight from the start differs, per change of the edge
// vector, from that of one carried step by step.
HyperVector detour(const MovingEdge& edge) {
  const HyperVector start = constant(edge.start_tangent);
  return -twist_gradient<HyperDual>(start, edge.tangent, edge.length, edge.length).f;
}

MovingEdge moving_edge(const Eigen::Vector3d& director, const HyperVector& e,
                       const HyperDual& theta) {
  MovingEdge edge;
  edge.length = sqrt(e.squaredNorm());
  edge.tangent = e / edge.length;
  for (int i = 0; i < 3; ++i) edge.start_tangent[i] = edge.tangent[i].value().value();
  const HyperVector start = constant(edge.start_tangent);
  const HyperVector d = constant(director);
  const HyperVector sum = start + edge.tangent;
  edge.director = d - sum * (d.dot(edge.tangent) * 2.0 / sum.squaredNorm());
  edge.theta = theta;
  return edge;
}

// The reference twist between two moving edges, `twist` at the start.
HyperDual moving_twist(const MovingEdge& before, const MovingEdge& after, double twist) {
  const HyperVector& u = after.tangent;
  const HyperVector sum = before.tangent + u;
  const HyperVector across =
      before.director - sum * (before.director.dot(u) * 2.0 / sum.squaredNorm());
  const HyperDual sine = u.dot(across.cross(after.director));
  const HyperDual cosine = across.dot(after.director);
  // The change of angle has no constant part, so it is its own sine up to what hyper-duals drop.
  return sine * cosine.value().value() - cosine * sine.value().value() + twist;
}

}  // namespace

Eigen::VectorXd third_derivative(const Rod& rod, const RodState& state, const Eigen::VectorXd& v,
                                 const Eigen::VectorXd& w) {
  const Section& s = rod.section;
  const TwistModel model = twist_model(rod);
  const int positions = 3 * rod.vertices();
  const auto difference = [&](const Eigen::VectorXd& a, int j) -> Eigen::Vector3d {
    return a.segment<3>(3 * next(rod, j)) - a.segment<3>(3 * j);
  };
  const auto along = [&](int j) {
    return hyper_dual_vector(edge(rod, state.x, j), difference(v, j), difference(w, j));
  };
  Eigen::VectorXd result = Eigen::VectorXd::Zero(unknowns(rod));
  const auto at = [&](int vertex) { return result.segment<3>(3 * vertex); };
  const auto add = [&](const Corner& c, const HyperVector& e_change, const HyperVector& f_change) {
    const Eigen::Vector3d e = mixed_part(e_change);
    const Eigen::Vector3d f = mixed_part(f_change);
    at(c.before) -= e;
    at(c.at) += e - f;
    at(c.after) += f;
  };
  for (int j = 0; j < rod.edges(); ++j) {
    const Eigen::Vector3d g =
        mixed_part(stretch_gradient<HyperDual>(s.EA, rod.rest_lengths[j], along(j)));
    at(j) -= g;
    at(next(rod, j)) += g;
  }

  if (model == TwistModel::per_edge) {
    const auto moving = [&](int j) {
      return moving_edge(state.frames.director.col(j), along(j),
                         hyper_dual(state.theta[j], v[positions + j], w[positions + j]));
    };
    for (int b = 0; b < rod.bending_vertices(); ++b) {
      const Corner c = corner(rod, b);
      const MovingEdge before = moving(c.edge_before);
      const MovingEdge after = moving(c.edge_after);
      FramedVertex<HyperDual> vertex;
      vertex.t = before.tangent;
      vertex.u = after.tangent;
      vertex.e_length = before.length;
      vertex.f_length = after.length;
      vertex.before = material_frame<HyperDual>(before.tangent, before.director, before.theta);
      vertex.after = material_frame<HyperDual>(after.tangent, after.director, after.theta);
      vertex.twist = moving_twist(before, after, state.frames.twist[b]) + after.theta -
                     before.theta + seam_angle(rod, b);
      const auto g = framed_gradient<HyperDual>(vertex_law(rod, b), vertex);
      add(c, g.e + detour(before) * g.theta_before, g.f + detour(after) * g.theta_after);
      result[positions + c.edge_before] += mixed_part(g.theta_before);
      result[positions + c.edge_after] += mixed_part(g.theta_after);
    }
    return result;
  }

  HyperDual moment;
  if (model == TwistModel::uniform)
    moment = hyper_dual(twisting_moment(rod, state), v[positions], w[positions]);
  for (int b = 0; b < rod.bending_vertices(); ++b) {
    const Corner c = corner(rod, b);
    const HyperVector e = along(c.edge_before);
    const HyperVector f = along(c.edge_after);
    const auto g = bend_gradient<HyperDual>(s.EI1, c.voronoi, e, f);
    add(c, g.e, g.f);
    if (model == TwistModel::uniform) {
      const auto excess = excess_gradient<HyperDual>(e, f);
      add(c, excess.e * moment, excess.f * moment);
      result[positions] += first_part(excess.e).dot(difference(w, c.edge_before)) +
                           first_part(excess.f).dot(difference(w, c.edge_after));
    }
  }
  return result;
}

}  // namespace tencer::der
