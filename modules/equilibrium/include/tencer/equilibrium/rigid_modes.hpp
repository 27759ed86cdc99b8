// The motions that leave a structure's energy as it is: rigid motions of each component of rods
// that its supports and loads allow. A load allows translations and turning about its own
// direction.
#pragma once

#include <Eigen/Core>
#include <tencer/equilibrium/system.hpp>
#include <vector>

namespace tencer::equilibrium {

// One for each component of rods that cables tie together (model::components). basis is size x r,
// orthonormal, r <= 6 the component's free rigid motions (3 in the plane, 5 for one straight rod,
// fewer with pins and anchors). stabilising is k x r, an orthonormal basis of the same motions
// restricted to System::stabilising_unknowns.
//
// H + R R^T, R = S^(1/2) Q, Q = stabilising and S the order of the stiffness of an edge of each
// unknown's rod, is regular where H is singular on rigid motions only, and exact: at an equilibrium
// its solves differ from the pseudo-inverse by rigid motions alone, and its inertia is that of H on
// the other motions plus r positive ones. Scaled so, it takes no digits from H, however much
// stiffer one rod is than another.
//
// steadiness, from 0 to about 1, is how far the allowed motion that moves the component least moves
// it: 0 for a straight rod that turns about itself. The modes turn with the rods and, as a rod
// straightens, one of them vanishes: they change by about what edges turn over steadiness.
struct RigidModes {
  Eigen::MatrixXd basis;
  Eigen::MatrixXd stabilising;
  double steadiness = 1.0;
};

std::vector<RigidModes> rigid_modes(const System& system, const model::State& state);

// That of the component where it is least.
double steadiness(const std::vector<RigidModes>& modes);

// How many components are left some rigid motion: two of them can move against each other at no
// cost.
int floating_components(const std::vector<RigidModes>& modes);

// Adds R R^T for every component.
void stabilise(const System& system, const std::vector<RigidModes>& modes,
               linalg::SymmetricMatrix& matrix);

// Whether loads do no work in these motions; if they do, the component moves on for ever and has no
// equilibrium.
bool holds_loads(const System& system, const std::vector<RigidModes>& modes);

// v less its rigid part (orthogonal projection), in place.
void remove_rigid(const std::vector<RigidModes>& modes, Eigen::Ref<Eigen::VectorXd> v);

}  // namespace tencer::equilibrium
