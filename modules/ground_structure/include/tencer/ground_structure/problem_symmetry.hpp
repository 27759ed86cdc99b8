// The symmetries of a problem: of its curves and anchors, and of all that is not to be seen of
// them.
#pragma once

#include <string>
#include <tencer/ground_structure/problem.hpp>
#include <tencer/symmetry/detect.hpp>
#include <tencer/symmetry/figure.hpp>
#include <tencer/symmetry/operation.hpp>

namespace tencer::ground_structure {

// The problem's curves and anchors; rods of different section are of different classes.
symmetry::Figure figure_of(const Problem& problem);

// What an operation would break of sections, pins, loads, weights and rules, in words after "it";
// empty: nothing. `operation` acts on the figure of the problem.
std::string broken_by(const symmetry::Operation& operation, const Problem& problem,
                      const symmetry::Figure& figure);

// What maps the problem onto itself within the tolerance (symmetry/detect.hpp), breaking nothing;
// at least the identity. The problem's own `symmetry` is not looked at.
symmetry::Symmetry detected(const Problem& problem, double tolerance);

}  // namespace tencer::ground_structure
