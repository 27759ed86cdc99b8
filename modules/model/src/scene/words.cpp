#include <algorithm>
#include <cmath>
#include <sstream>
#include <tencer/model/units.hpp>
#include <tencer/model/words.hpp>

#include "scene/with_digits.hpp"

namespace tencer::model {

std::string with_digits(double value, int digits) {
  std::ostringstream text;
  text.precision(std::max(digits, static_cast<int>(std::log10(std::max(value, 1.0))) + 1));
  text << value;
  return text.str();
}

std::string in_words(const der::Shape& shape, std::string_view length_unit) {
  const bool known = std::ranges::find(length_units(), length_unit) != length_units().end();
  const double factor = known ? metres(length_unit) / metres("mm") : 1.0;
  const std::string unit = ' ' + (known ? std::string("mm") : std::string(length_unit));
  const auto size = [&](double value) { return with_digits(value * factor, 3); };
  if (const auto* circle = std::get_if<der::Circle>(&shape))
    return "circle r " + size(circle->radius) + unit;
  if (const auto* tube = std::get_if<der::Tube>(&shape))
    return "tube r " + size(tube->outer_radius) + " / " + size(tube->inner_radius) + unit;
  if (const auto* rectangle = std::get_if<der::Rectangle>(&shape))
    return "rectangle " + size(rectangle->width) + " x " + size(rectangle->height) + unit;
  return "section by its stiffnesses";
}

std::string in_words(const Material& material) {
  std::string text = material.name;
  const auto named = find_material(material.name);
  const auto differs = [](double a, double b) { return std::abs(a - b) > 1e-3 * std::abs(b); };
  if (!named || differs(material.youngs_modulus, named->youngs_modulus))
    text += " with E " + with_digits(material.youngs_modulus / 1e9, 3) + " GPa";
  return text;
}

std::string mass_in_words(double kilograms) {
  return kilograms < 1 ? with_digits(kilograms * 1e3, 2) + " g" : with_digits(kilograms, 3) + " kg";
}

}  // namespace tencer::model
