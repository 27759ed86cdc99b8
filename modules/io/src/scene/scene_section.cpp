#include "scene/scene_section.hpp"

#include <array>
#include <tencer/core/error.hpp>
#include <tencer/model/units.hpp>

namespace tencer::io {
namespace {

constexpr std::array<std::string_view, 3> shapes{"circle", "tube", "rectangle"};

// EI as one number or as [a, b].
Eigen::Vector2d bending_stiffness(const TomlTable& section) {
  if (!section.is_array("EI"))
    return Eigen::Vector2d::Constant(section.need("EI", section.positive("EI")));
  const std::vector<double> pair = *section.numbers("EI");
  if (pair.size() != 2 || pair[0] <= 0 || pair[1] <= 0)
    section.fail("EI", "expected a positive number, or two of them [a, b]");
  return {pair[0], pair[1]};
}

void read_stiffnesses(const TomlTable& section, SectionWish& wish) {
  section.only({"EA", "EI", "GJ", "mass_per_length"});
  const Eigen::Vector2d bending = bending_stiffness(section);
  wish.shape = std::monostate();
  wish.stiffnesses = {.EA = section.need("EA", section.positive("EA")),
                      .EI1 = bending[0],
                      .EI2 = bending[1],
                      .GJ = section.need("GJ", section.positive("GJ"))};
  wish.mass_per_length = section.at_least_zero("mass_per_length");
}

der::Shape read_shape(const TomlTable& section) {
  const std::string shape = section.one_of("shape", shapes).value_or("circle");
  if (shape == "circle") {
    section.only({"shape", "radius", "youngs_modulus", "poisson", "density", "EA", "EI", "GJ"});
    return der::Circle{section.positive("radius").value_or(0.0)};
  }
  if (shape == "tube") {
    section.only({"shape", "outer_radius", "inner_radius", "youngs_modulus", "poisson", "density"});
    const der::Tube tube{section.need("outer_radius", section.positive("outer_radius")),
                         section.need("inner_radius", section.at_least_zero("inner_radius"))};
    if (tube.inner_radius >= tube.outer_radius)
      section.fail("inner_radius", "must be smaller than outer_radius");
    return tube;
  }
  section.only({"shape", "width", "height", "youngs_modulus", "poisson", "density"});
  return der::Rectangle{section.need("width", section.positive("width")),
                        section.need("height", section.positive("height"))};
}

std::vector<std::string_view> material_names() {
  std::vector<std::string_view> names;
  for (const model::Material& material : model::materials()) names.push_back(material.name);
  return names;
}

}  // namespace

SectionWish section_wish(const TomlTable& rod, const Units& units,
                         const model::Material& standard) {
  SectionWish wish{.material = standard};
  if (const auto name = rod.one_of("material", material_names()))
    wish.material = *model::find_material(*name);
  const auto section = rod.table("section");
  if (!section) return wish;
  if (section->has("EA") || section->has("EI") || section->has("GJ")) {
    if (rod.has("material"))
      rod.fail("material", "has no meaning: the section is given by its stiffnesses");
    read_stiffnesses(*section, wish);
    return wish;
  }
  wish.shape = read_shape(*section);
  if (const auto modulus = section->positive("youngs_modulus")) {
    const double metre = model::metres(units.length);
    wish.material.youngs_modulus = *modulus * model::newtons(units.force) / (metre * metre);
  }
  if (const auto density = section->at_least_zero("density")) wish.material.density = *density;
  wish.poisson = section->number("poisson").value_or(wish.poisson);
  if (wish.poisson <= -1.0 || wish.poisson > 0.5)
    section->fail("poisson", "expected a number above -1, at most 0.5");
  return wish;
}

der::Section section(const SectionWish& wish, double radius, const Units& units) {
  const double modulus = model::youngs_modulus_in(wish.material, units.length, units.force);
  if (const auto* circle = std::get_if<der::Circle>(&wish.shape))
    return der::solid_circle(modulus, wish.poisson,
                             wish.radius_to_choose() ? radius : circle->radius);
  if (const auto* tube = std::get_if<der::Tube>(&wish.shape))
    return der::tube(modulus, wish.poisson, tube->outer_radius, tube->inner_radius);
  if (const auto* rectangle = std::get_if<der::Rectangle>(&wish.shape))
    return der::rectangle(modulus, wish.poisson, rectangle->width, rectangle->height);
  return wish.stiffnesses;
}

std::optional<double> mass_per_length(const SectionWish& wish, const der::Section& section,
                                      const Units& units) {
  if (std::holds_alternative<std::monostate>(wish.shape)) return wish.mass_per_length;
  return model::mass_per_length(wish.material, section.shape, units.length);
}

}  // namespace tencer::io
