// The curve families by name, with their parameters, for scene files and command lines.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <tencer/geometry/polyline.hpp>
#include <vector>

namespace tencer::curves {

struct FamilyParameter {
  std::string_view name;
  double standard = 0.0;  // the value when none is given
  bool integer = false;
  std::string_view meaning;
};

// Every parameter is a positive number.
struct Family {
  std::string name;
  std::string meaning;
  int vertices = 0;  // of each rod, when none is given
  std::vector<FamilyParameter> parameters;
};

// All families, in a fixed order: circle, ellipse, helix, torus-knot, trefoil-hypotrochoid,
// trefoil-2-3, trefoil-3-2, twin-trefoils, borromean-ellipses, and knot-NAME for each of
// knot_table().
std::vector<Family> families();

// What is wrong with these parameter values (one for each of the family's parameters, in its order,
// or throws std::invalid_argument) and number of vertices, in words for a user; none when curves
// can be made of them.
[[nodiscard]] std::optional<std::string> family_problem(const Family& family,
                                                        std::span<const double> values,
                                                        int vertices);

// The curves of a family; each has `vertices` vertices. Throws std::invalid_argument for values
// with a family_problem and for a family that is none of families().
std::vector<geometry::Polyline> family_curves(const Family& family, std::span<const double> values,
                                              int vertices);

}  // namespace tencer::curves
