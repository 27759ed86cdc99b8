// Between the design file's plain data, in the user's units, and structures in scaled units.
#pragma once

#include <Eigen/Core>
#include <tencer/equilibrium/structure.hpp>
#include <tencer/io/design.hpp>
#include <tencer/pipeline/prepare.hpp>
#include <vector>

namespace tencer::pipeline {

// How the cables of a design file are taken.
enum class Cables { springs, inextensible };

// Scaled rods with their section and rest shape, cables, supports and loads. Springs need a
// stiffness and rest length in the file; inextensible cables have their length as rest_length.
equilibrium::Structure structure_of(const io::Design& design, Cables cables, const Units& units);

// The units in which a design is solved.
Units units_of(const io::Design& design);

// Scaled points of every rod.
std::vector<Eigen::Matrix3Xd> scaled_targets(const io::Design& design, const Units& units);
std::vector<Eigen::Matrix3Xd> scaled_poses(const io::Design& design, const Units& units);

// The rods at the file's target, and moved on from there to its pose. Material frames are the
// file's; where it has none at the target, those that cost least there.
equilibrium::State target_state(const io::Design& design, const equilibrium::Structure& structure,
                                const Units& units);
equilibrium::State pose_state(const io::Design& design, const equilibrium::Structure& structure,
                              const Units& units);

// A cable end as the file has it: s wrapped into [0, L] of its rod, in the user's units.
io::CableEnd file_end(const springs::End& end, const equilibrium::Structure& structure,
                      const Units& units);

}  // namespace tencer::pipeline
