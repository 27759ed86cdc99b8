// Material frames of rods that keep an angle per edge: how they start out on given vertices, and
// how files have them. Other rods are left alone.
#pragma once

#include <Eigen/Core>
#include <tencer/der/rod.hpp>

namespace tencer::model {

// Turns all of the rod's frames by the same angle, so that m1 of the first edge points to `m1`, as
// far as that is perpendicular to the edge.
void turn_frames(der::RodState& state, const Eigen::Vector3d& m1);

// Turns them alike to where the rod's energy is least, among 16 angles.
void turn_to_least_energy(const der::Rod& rod, der::RodState& state);

// Each edge's m1 as given (3 x edges), by the angles that twist the rod most nearly as `state` does
// (a direction says nothing of full turns).
void set_frames(der::RodState& state, const Eigen::Matrix3Xd& m1);

// m1 of every edge, 3 x edges; no columns for rods without frames.
Eigen::Matrix3Xd directors(const der::RodState& state);

}  // namespace tencer::model
