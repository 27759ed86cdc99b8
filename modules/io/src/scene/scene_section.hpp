// The section table of a rod.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <tencer/der/section.hpp>

#include "scene/toml_value.hpp"

namespace tencer::io {

enum class SectionShape { circle, tube, rectangle, stiffnesses };

// What a [[rod]] table says about the sections of its rods; defaults depend on all rods.
struct SectionWish {
  SectionShape shape = SectionShape::circle;
  std::optional<double> radius = std::nullopt;  // circle
  // tube: outer and inner radius; rectangle: width along the first axis and height along the
  // second.
  double first = 0.0;
  double second = 0.0;
  der::Section stiffnesses{};
  std::optional<double> youngs_modulus = std::nullopt;
  double poisson = 0.3;
  std::optional<double> density = std::nullopt;  // kg/m^3; stiffnesses: kg/m
};

SectionWish section_wish(const TomlTable& rod);

struct Units {
  std::string length;
  std::string force;
};

// `radius` when the wish is a circle without one.
der::Section section(const SectionWish& wish, double radius, const Units& units);

// The weight per length in the scene's units of a rod under `gravity` (m/s^2). Requires a density.
Eigen::Vector3d weight_per_length(const SectionWish& wish, const der::Section& section,
                                  const Eigen::Vector3d& gravity, const Units& units);

}  // namespace tencer::io
