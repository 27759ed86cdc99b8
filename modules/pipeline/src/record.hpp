// Writes an equilibrium into a design file's data.
#pragma once

#include <tencer/equilibrium/built.hpp>
#include <tencer/io/design.hpp>
#include <tencer/pipeline/convert.hpp>
#include <tencer/sensitivity/target.hpp>

namespace tencer::pipeline {

// The target of a structure with its cables: aligned unless pins or cables to anchors hold it.
sensitivity::Target target_of(const equilibrium::Structure& structure,
                              std::vector<Eigen::Matrix3Xd> points,
                              std::vector<Eigen::VectorXd> weights = {});

// Sets poses and their directors (moved onto the target when that is aligned), lengths and tensions
// of the cables, error and certificate. design.cables has the structure's cables in the same order.
void record(const equilibrium::Structure& structure, const equilibrium::State& state,
            const Eigen::VectorXd& tensions, const sensitivity::Target& target, const Units& units,
            io::Design& design);

}  // namespace tencer::pipeline
