#include "framed_rod.hpp"
#include "motion.hpp"

namespace tencer::der {
namespace {

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

void add_framed_third_derivative(const Motion& motion, Eigen::VectorXd& result) {
  const Rod& rod = motion.rod;
  const RodState& state = motion.state;
  const int first = 3 * rod.vertices();
  const auto moving = [&](int j) {
    return moving_edge(state.frames.director.col(j), motion.along(j),
                       hyper_dual(state.theta[j], motion.v[first + j], motion.w[first + j]));
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
    vertex.twist = moving_twist(before, after, state.frames.twist[b]) + after.theta - before.theta +
                   seam_angle(rod, b);
    const auto g = framed_gradient<HyperDual>(vertex_law(rod, b), vertex);
    add_to_vertices(c, mixed_part(HyperVector(g.e + detour(before) * g.theta_before)),
                    mixed_part(HyperVector(g.f + detour(after) * g.theta_after)), result);
    result[first + c.edge_before] += mixed_part(g.theta_before);
    result[first + c.edge_after] += mixed_part(g.theta_after);
  }
}

}  // namespace tencer::der
