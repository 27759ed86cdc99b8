#include "scene/scene_section.hpp"

#include <algorithm>
#include <array>
#include <tencer/core/error.hpp>
#include <tencer/model/scene.hpp>
#include <tencer/model/units.hpp>

namespace tencer::io {
namespace {

constexpr std::array<std::string_view, 3> shapes{"circle", "tube", "rectangle"};

double modulus(const SectionWish& wish, const Units& units) {
  return wish.youngs_modulus.value_or(model::glass_fibre_modulus(units.length, units.force));
}

// EI as one number or as [a, b].
Eigen::Vector2d bending_stiffness(const TomlTable& section) {
  if (!section.is_array("EI"))
    return Eigen::Vector2d::Constant(section.need("EI", section.positive("EI")));
  const std::vector<double> pair = *section.numbers("EI");
  if (pair.size() != 2 || pair[0] <= 0 || pair[1] <= 0)
    section.fail("EI", "expected a positive number, or two of them [a, b]");
  return {pair[0], pair[1]};
}

SectionWish read_stiffnesses(const TomlTable& section) {
  section.only({"EA", "EI", "GJ", "mass_per_length"});
  const Eigen::Vector2d bending = bending_stiffness(section);
  return {.shape = SectionShape::stiffnesses,
          .stiffnesses = {.EA = section.need("EA", section.positive("EA")),
                          .EI1 = bending[0],
                          .EI2 = bending[1],
                          .GJ = section.need("GJ", section.positive("GJ"))},
          .density = section.at_least_zero("mass_per_length")};
}

}  // namespace

SectionWish section_wish(const TomlTable& rod) {
  const auto section = rod.table("section");
  if (!section) return {};
  if (section->has("EA") || section->has("EI") || section->has("GJ"))
    return read_stiffnesses(*section);
  SectionWish wish;
  const std::string shape = section->one_of("shape", shapes).value_or("circle");
  if (shape == "circle") {
    section->only({"shape", "radius", "youngs_modulus", "poisson", "density", "EA", "EI", "GJ"});
    wish.radius = section->positive("radius");
  } else if (shape == "tube") {
    section->only(
        {"shape", "outer_radius", "inner_radius", "youngs_modulus", "poisson", "density"});
    wish.shape = SectionShape::tube;
    wish.first = section->need("outer_radius", section->positive("outer_radius"));
    wish.second = section->need("inner_radius", section->at_least_zero("inner_radius"));
    if (wish.second >= wish.first)
      section->fail("inner_radius", "must be smaller than outer_radius");
  } else {
    section->only({"shape", "width", "height", "youngs_modulus", "poisson", "density"});
    wish.shape = SectionShape::rectangle;
    wish.first = section->need("width", section->positive("width"));
    wish.second = section->need("height", section->positive("height"));
  }
  wish.youngs_modulus = section->positive("youngs_modulus");
  wish.poisson = section->number("poisson").value_or(wish.poisson);
  if (wish.poisson <= -1.0 || wish.poisson > 0.5)
    section->fail("poisson", "expected a number above -1, at most 0.5");
  wish.density = section->at_least_zero("density");
  return wish;
}

der::Section section(const SectionWish& wish, double radius, const Units& units) {
  switch (wish.shape) {
    case SectionShape::circle:
      return der::solid_circle(modulus(wish, units), wish.poisson, wish.radius.value_or(radius));
    case SectionShape::tube:
      return der::tube(modulus(wish, units), wish.poisson, wish.first, wish.second);
    case SectionShape::rectangle:
      return der::rectangle(modulus(wish, units), wish.poisson, wish.first, wish.second);
    case SectionShape::stiffnesses:
      return wish.stiffnesses;
  }
  return {};
}

Eigen::Vector3d weight_per_length(const SectionWish& wish, const der::Section& section,
                                  const Eigen::Vector3d& gravity, const Units& units) {
  core::require(wish.density.has_value(), "weight_per_length: needs a density");
  const double metre = model::metres(units.length);
  const double newton = model::newtons(units.force);
  double kg_per_m = *wish.density;
  if (wish.shape != SectionShape::stiffnesses)
    kg_per_m *= section.EA / modulus(wish, units) * metre * metre;
  return kg_per_m * gravity * (metre / newton);
}

}  // namespace tencer::io
