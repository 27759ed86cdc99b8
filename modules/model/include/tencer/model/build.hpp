// What a design has to stand when it is built: how exactly it is made, and what must not touch.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <tencer/model/allowance.hpp>
#include <tencer/model/rules.hpp>

namespace tencer::model {

// What a workshop does without taking pains: the largest errors of a cable's length and of a mark
// along its rod, where nobody says others.
inline constexpr double usual_length_error_mm = 1;
inline constexpr double usual_attachment_error_mm = 2;

// Lengths and forces are in the scene's units. docs/scene.md says more of each under its name.
struct BuildSettings {
  // Errors are uniform between plus and minus these.
  std::optional<double> length_error{};      // of a cable's length; not set: the usual one
  std::optional<double> attachment_error{};  // of a mark along its rod; not set: the usual one
  // How far the errors may move the pose (95 %); not set: as far as the pose may be from the
  // target.
  std::optional<Allowance> max_deviation{};
  std::optional<double> clearance{};      // see Gaps
  std::optional<double> mark_distance{};  // likewise
  bool layers = false;  // cables may cross rods: they lie in another layer of a flat structure
  double min_tension_ratio = 0.02;      // the weakest cable's tension, of the strongest's
  std::optional<double> min_tension{};  // likewise, a force, beside the ratio

  // What is wrong, beginning with the name of the field; not set: nothing.
  std::optional<std::string> problem() const;

  // With what is not set filled in, in a scene's unit of length; 0 where that is none of units.hpp.
  double length_error_in(std::string_view length_unit) const;
  double attachment_error_in(std::string_view length_unit) const;
  std::optional<Gaps> gaps() const;  // none with layers
};

}  // namespace tencer::model
