#include <tencer/der/energy.hpp>

#include "motion.hpp"
#include "reduced.hpp"
#include "uniform_twist.hpp"

namespace tencer::der {
namespace {

void add_stretching(const Motion& motion, Eigen::VectorXd& result) {
  const Rod& rod = motion.rod;
  for (int j = 0; j < rod.edges(); ++j) {
    const Eigen::Vector3d g = mixed_part(
        stretch_gradient<HyperDual>(rod.section.EA, rod.rest_lengths[j], motion.along(j)));
    result.segment<3>(3 * j) -= g;
    result.segment<3>(3 * next(rod, j)) += g;
  }
}

void add_reduced_bending(const Motion& motion, Eigen::VectorXd& result) {
  const Rod& rod = motion.rod;
  for (int b = 0; b < rod.bending_vertices(); ++b) {
    const Corner c = corner(rod, b);
    const auto g = bend_gradient<HyperDual>(rod.section.EI1, c.voronoi, motion.along(c.edge_before),
                                            motion.along(c.edge_after));
    add_to_vertices(c, mixed_part(g.e), mixed_part(g.f), result);
  }
}

void add_uniform_twisting(const Motion& motion, Eigen::VectorXd& result) {
  const Rod& rod = motion.rod;
  const int m = 3 * rod.vertices();
  const HyperDual moment = hyper_dual(twisting_moment(rod, motion.state), motion.v[m], motion.w[m]);
  for (int b = 0; b < rod.bending_vertices(); ++b) {
    const Corner c = corner(rod, b);
    const auto g =
        excess_gradient<HyperDual>(motion.along(c.edge_before), motion.along(c.edge_after));
    add_to_vertices(c, mixed_part(HyperVector(g.e * moment)), mixed_part(HyperVector(g.f * moment)),
                    result);
    result[m] += first_part(g.e).dot(motion.difference(motion.w, c.edge_before)) +
                 first_part(g.f).dot(motion.difference(motion.w, c.edge_after));
  }
}

}  // namespace

Eigen::VectorXd third_derivative(const Rod& rod, const RodState& state, const Eigen::VectorXd& v,
                                 const Eigen::VectorXd& w) {
  const Motion motion{rod, state, v, w};
  Eigen::VectorXd result = Eigen::VectorXd::Zero(unknowns(rod));
  add_stretching(motion, result);
  const TwistModel model = twist_model(rod);
  if (model == TwistModel::per_edge) {
    add_framed_third_derivative(motion, result);
  } else {
    add_reduced_bending(motion, result);
    if (model == TwistModel::uniform) add_uniform_twisting(motion, result);
  }
  return result;
}

}  // namespace tencer::der
