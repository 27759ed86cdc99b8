// A rod's elastic energy and its derivatives, element by element (paper eq. 1). Units are those of
// the rod: a length and a force. Rods have passed validate(), states come from make_state() and
// displace(), and vectors have the sizes stated; none of this is checked again.
#pragma once

#include <Eigen/Core>
#include <functional>
#include <tencer/der/rod.hpp>
#include <vector>

namespace tencer::der {

// A rod's own unknowns in order: 3 n positions (x0 y0 z0 x1 ...), then one theta per edge when the
// twist is per edge, or one twisting moment when it is uniform.
int unknowns(const Rod& rod);

// The unknowns that each element of the Hessian couples: first the edges (6 each), then the bending
// vertices (9 each, with uniform twist 10, with per-edge twist 11).
std::vector<std::vector<int>> elements(const Rod& rod);

// Stretching + bending + twisting energy at `state`; infinite where a vertex is folded flat or an
// edge has no length.
double energy(const Rod& rod, const RodState& state);

// Adds dE/d(unknowns) to `gradient`, of unknowns(rod) entries. With uniform twist the moment is at
// its stationary value, so its entry stays zero.
void add_gradient(const Rod& rod, const RodState& state, Eigen::Ref<Eigen::VectorXd> gradient);

// Axial forces EA (|e| / l - 1), per edge; tension positive.
Eigen::VectorXd axial_forces(const Rod& rod, const Eigen::Matrix3Xd& x);

// Receives the Hessian of one element: k x k, column major, symmetric, k the length of its list.
// The matrix is there only during the call.
using ElementSink = std::function<void(int element, const double* matrix)>;

// Sends every element's Hessian to `sink` in the order of elements(). `axial` (per edge) is the
// force in the geometric stiffness: axial_forces(rod, x) gives the Hessian itself; a Newton
// iteration may pass a prediction of it instead (mixed formulation), which converges in far fewer
// steps when EA is large. With uniform twist the moment is a Lagrange-like unknown: its pivot is
// negative.
void hessian(const Rod& rod, const RodState& state, const Eigen::VectorXd& axial,
             const ElementSink& sink);

// (D^2 gradient)[v, w] = d/da d/db of the gradient along a v + b w: the third derivative of the
// energy contracted twice; v, w of unknowns(rod) entries. With uniform twist, of the mixed energy
// whose Hessian is hessian()'s, so the moment's entries count.
Eigen::VectorXd third_derivative(const Rod& rod, const RodState& state, const Eigen::VectorXd& v,
                                 const Eigen::VectorXd& w);

// Moves `state` by `step` (unknowns(rod) entries; theta and positions; the moment is ignored) and
// carries reference frames and holonomy along by time-parallel transport. Gradient, Hessian and
// third derivative are those of step -> energy(displaced state) at step 0. In a per-edge rod two
// steps in turn differ from their sum, in second order, by a rotation of each frame about its edge;
// the Hessian therefore is the symmetric part of the derivative of the gradient, and all of it
// where the twisting moments on the edges balance.
void displace(const Rod& rod, RodState& state, const Eigen::Ref<const Eigen::VectorXd>& step);

// The step whose direction rotates the rod rigidly about the origin with angular velocity omega:
// omega x x of each vertex, omega . tangent of each theta.
Eigen::VectorXd rotation_step(const Rod& rod, const RodState& state, const Eigen::Vector3d& omega);

}  // namespace tencer::der
