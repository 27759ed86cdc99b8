// What a scene's symmetries must keep that is not to be seen of curves and anchors.
#pragma once

#include <string>
#include <tencer/ground_structure/problem.hpp>
#include <tencer/symmetry/figure.hpp>
#include <tencer/symmetry/operation.hpp>

namespace tencer::pipeline {

// The problem's curves and anchors; rods of different section are of different classes.
symmetry::Figure figure_of(const ground_structure::Problem& problem);

// What an operation would break of sections, pins, loads, weights and rules, in words after "it";
// empty: nothing. `operation` acts on the figure of the problem.
std::string broken_by(const symmetry::Operation& operation,
                      const ground_structure::Problem& problem, const symmetry::Figure& figure);

}  // namespace tencer::pipeline
