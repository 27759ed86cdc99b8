// The symmetries of a set of curves: found, or given and checked. Compared are the smooth curves
// through the vertices, by arc length at rest, so vertices need not fall onto vertices.
#pragma once

#include <functional>
#include <span>
#include <string>
#include <tencer/core/error.hpp>
#include <tencer/model/symmetry.hpp>
#include <tencer/symmetry/figure.hpp>
#include <tencer/symmetry/group.hpp>
#include <vector>

namespace tencer::symmetry {

// tolerance: the largest misfit, the distance between the image of a vertex or an anchor and the
// place of the figure that it stands for, over the diagonal of the curves' bounding box.
// continuous_fold: a figure that turns into itself by any angle (a circle of many vertices) is
// given this many rotations about its axis. objection: what an operation would break that a figure
// does not show, such as a load, in words after "it"; empty: nothing. Only the matrix, the rods and
// the anchors of its argument count.
struct Options {
  double tolerance = 1e-3;
  int max_order = 240;
  int continuous_fold = 12;
  std::function<std::string(const Operation&)> objection{};  // may be empty

  // Throws std::invalid_argument, naming the field, unless tolerance is in (0, 0.05) and the
  // others are positive.
  void validate() const;
};

// misfit: the largest over the group's operations. elements: the group's axes, each with its
// highest fold, highest first, and then its mirror planes, all with their points; `verify` makes
// the group of them again, but for the rare ones that hold an inversion or rotary reflection these
// do not make.
struct Symmetry {
  Group group{};
  std::vector<model::SymmetryGenerator> elements{};
  double misfit = 0.0;
};

// All rotations and reflections, and products of the two, about the curves' centroid that map the
// figure onto itself within the tolerance, without objection; at least the identity.
Symmetry detect(const Figure& figure, const Options& options = {});

// The group that the generators make. Error{"symmetry[i]", ...} when generator i misses the figure,
// saying by how much and where, or meets an objection, or Error{"symmetry", ...} when they do not
// make a finite group.
core::Expected<Symmetry> verify(const Figure& figure,
                                std::span<const model::SymmetryGenerator> generators,
                                const Options& options = {});

}  // namespace tencer::symmetry
