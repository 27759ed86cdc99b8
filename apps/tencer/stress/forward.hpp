// Rows about equilibria: solved, certified and compared with a known answer.
#pragma once

#include <chrono>
#include <functional>
#include <stop_token>
#include <tencer/equilibrium/inextensible.hpp>
#include <tencer/equilibrium/solve.hpp>
#include <tencer/equilibrium/stability.hpp>

#include "elastica.hpp"
#include "row.hpp"

namespace tencer::app::stress {

// A rod of EI = 1 (times `bending`) and a solid circular section, length / radius = slenderness.
der::Rod slender_rod(bool closed, Eigen::VectorXd rest_lengths, double slenderness,
                     double bending = 1.0);
Eigen::VectorXd equal_lengths(int edges, double length = 1.0);

// A regular polygon in the plane z = 0.
Eigen::Matrix3Xd polygon(int vertices, double circumference);

using Positions = std::vector<Eigen::Matrix3Xd>;  // per rod

// How far a state is from the known answer, relative.
using Error = std::function<double(const model::State&)>;

// Largest distance of a vertex of rod `rod` from `x`, after the best rigid motion, relative to
// `size`.
Error distance_from(Eigen::Matrix3Xd x, double size, int rod = 0);

struct Forward {
  std::string name;
  model::Structure structure;
  Positions start;
  std::string known;
  double promise;
  Error error;
};

// With the cables as springs. The row's iterations, residual and words are solve()'s; its
// stability is stability()'s.
Row forward(const Forward& forward);
// With inextensible cables of their rest lengths: relax_inextensible() and assess().
Row built(const Forward& forward);

// A bow of the given rod between two fixed points, started from a parabolic arch of another height.
Forward pinned_bow(std::string name, const der::Rod& rod, double angle, double promise);
// The same between the ends of a cable that cannot stretch, free in space.
Forward strung_bow(std::string name, const der::Rod& rod, double angle, double promise);
// The arch: `span` wide, `height` high.
Eigen::Matrix3Xd arch(const der::Rod& rod, double span, double height);

}  // namespace tencer::app::stress
