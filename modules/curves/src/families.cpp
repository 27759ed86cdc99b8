#include <algorithm>
#include <cmath>
#include <numeric>
#include <tencer/core/error.hpp>
#include <tencer/curves/analytic.hpp>
#include <tencer/curves/families.hpp>
#include <tencer/curves/knots.hpp>

namespace tencer::curves {

using geometry::Polyline;

namespace {

constexpr std::string_view knot_prefix = "knot-";

}  // namespace

std::vector<Family> families() {
  std::vector<Family> list{
      {"circle", "a circle", 100, {{"radius", 25, false, "radius"}}},
      {"ellipse",
       "an ellipse",
       100,
       {{"semi_x", 32.5, false, "semi-axis along x"}, {"semi_y", 25, false, "semi-axis along y"}}},
      {"helix",
       "a cylindrical helix, open (figure 11)",
       100,
       {{"diameter", 50, false, "diameter of the cylinder"},
        {"pitch", 33, false, "rise of one turn"},
        {"turns", 1.5, false, "number of turns"}}},
      {"torus-knot",
       "a (p, q) torus knot (figure 10)",
       201,
       {{"p", 5, true, "windings about the axis of the torus"},
        {"q", 3, true, "windings about its inner circle"},
        {"major", 13.5, false, "radius of the inner circle"},
        {"minor", 5.4, false, "radius of the tube"}}},
      {"trefoil-hypotrochoid",
       "a trefoil seen from above as a hypotrochoid (figure 9)",
       102,
       {{"length", 198, false, "arc length"}}},
      {"trefoil-2-3",
       "a trefoil as (2, 3) torus knot (figure 9)",
       102,
       {{"length", 198, false, "arc length"}}},
      {"trefoil-3-2",
       "a trefoil as (3, 2) torus knot (figure 9)",
       102,
       {{"length", 198, false, "arc length"}}},
      {"twin-trefoils",
       "two (2, 3) torus knots turned by 60 degrees (figure 1)",
       102,
       {{"major", 27, false, "radius of the inner circle"},
        {"minor", 10.8, false, "radius of the tube"}}},
      {"borromean-ellipses",
       "three perpendicular ellipses, linked as Borromean rings (figure 12)",
       100,
       {{"long_axis", 6.5, false, "longer semi-axis"},
        {"short_axis", 5, false, "shorter semi-axis"}}},
  };
  for (const KnotBraid& braid : knot_table())
    list.push_back({std::string(knot_prefix) + std::string(braid.name),
                    "the knot " + std::string(braid.name) + ", smooth and roomy (figure 16)",
                    200,
                    {{"length", 300, false, "arc length"}}});
  return list;
}

std::optional<std::string> family_problem(const Family& family, std::span<const double> values,
                                          int vertices) {
  core::require(values.size() == family.parameters.size(),
                "family_problem: needs one value for each parameter");
  for (std::size_t i = 0; i < values.size(); ++i) {
    const FamilyParameter& parameter = family.parameters[i];
    const std::string name(parameter.name);
    if (!std::isfinite(values[i]) || values[i] <= 0) return name + " must be a positive number";
    if (parameter.integer && (values[i] != std::floor(values[i]) || values[i] > 1000))
      return name + " must be a whole number from 1 to 1000";
  }
  if (vertices < 3) return "vertices must be at least 3";
  if (vertices > geometry::max_vertices)
    return "vertices must be at most " + std::to_string(geometry::max_vertices);
  if (family.name == "torus-knot" &&
      std::gcd(static_cast<int>(values[0]), static_cast<int>(values[1])) != 1)
    return "p and q must have no common divisor, or the curve is traced several times";
  if (family.name == "torus-knot" && values[2] <= values[3])
    return "major must be larger than minor";
  if (family.name == "twin-trefoils" && values[0] <= values[1])
    return "major must be larger than minor";
  if (family.name == "borromean-ellipses" && values[0] <= values[1])
    return "long_axis must be larger than short_axis";
  return std::nullopt;
}

std::vector<Polyline> family_curves(const Family& family, std::span<const double> values,
                                    int vertices) {
  core::require(!family_problem(family, values, vertices), "family_curves: unusable parameters");
  const auto is = [&](std::string_view name) { return family.name == name; };
  if (is("circle")) return {circle(values[0], vertices)};
  if (is("ellipse")) return {ellipse(values[0], values[1], vertices)};
  if (is("helix")) return {helix(values[0], values[1], values[2], vertices)};
  if (is("torus-knot"))
    return {torus_knot(static_cast<int>(values[0]), static_cast<int>(values[1]), values[2],
                       values[3], vertices)};
  if (is("trefoil-hypotrochoid")) return {trefoil(TrefoilForm::hypotrochoid, values[0], vertices)};
  if (is("trefoil-2-3")) return {trefoil(TrefoilForm::torus_2_3, values[0], vertices)};
  if (is("trefoil-3-2")) return {trefoil(TrefoilForm::torus_3_2, values[0], vertices)};
  if (is("twin-trefoils")) return twin_trefoils(values[0], values[1], vertices);
  if (is("borromean-ellipses")) return borromean_ellipses(values[0], values[1], vertices);
  const std::vector<KnotBraid> knots = knot_table();
  const auto braid = std::ranges::find_if(knots, [&](const KnotBraid& knot) {
    return family.name == std::string(knot_prefix) + std::string(knot.name);
  });
  core::require(braid != knots.end(), "family_curves: not a family of families()");
  return {knot(*braid, values[0], vertices)};
}

}  // namespace tencer::curves
