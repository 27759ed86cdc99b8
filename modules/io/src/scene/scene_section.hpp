// The section table of a rod.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <tencer/der/section.hpp>
#include <tencer/model/material.hpp>

#include "scene/toml_value.hpp"

namespace tencer::io {

struct Units {
  std::string length;
  std::string force;
};

// What a [[rod]] table says about the sections of its rods and what they are made of.
struct SectionWish {
  der::Shape shape = der::Circle{};  // a circle of radius 0: to be chosen, which all rods decide
  der::Section stiffnesses{};        // when there is no shape
  model::Material material{};        // with the modulus and density that the section says
  double poisson = 0.3;
  std::optional<double> mass_per_length = std::nullopt;  // kg/m, when there is no shape

  bool radius_to_choose() const {
    const auto* circle = std::get_if<der::Circle>(&shape);
    return circle && circle->radius == 0;
  }
};

// `standard` is the material of a rod that says none.
SectionWish section_wish(const TomlTable& rod, const Units& units, const model::Material& standard);

// `radius` when it is to be chosen.
der::Section section(const SectionWish& wish, double radius, const Units& units);

// kg/m of a rod with this section; not set: not known.
std::optional<double> mass_per_length(const SectionWish& wish, const der::Section& section,
                                      const Units& units);

}  // namespace tencer::io
