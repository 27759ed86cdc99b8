#include <algorithm>
#include <array>
#include <cmath>
#include <tencer/model/build.hpp>
#include <tencer/model/units.hpp>
#include <utility>

namespace tencer::model {
namespace {

// 0 when the unit is not known: then nothing is known of errors in it either.
double millimetre_in(std::string_view length_unit) {
  const bool known = std::ranges::find(length_units(), length_unit) != length_units().end();
  return known ? 1e-3 / metres(length_unit) : 0.0;
}

}  // namespace

std::optional<std::string> BuildSettings::problem() const {
  const auto at_least_zero = [](const std::optional<double>& value) {
    return !value || (*value >= 0 && std::isfinite(*value));
  };
  using Named = std::pair<const char*, const std::optional<double>*>;
  for (const auto& [name, value] :
       {Named{"length_error", &length_error}, Named{"attachment_error", &attachment_error},
        Named{"clearance", &clearance}, Named{"mark_distance", &mark_distance},
        Named{"min_tension", &min_tension}})
    if (!at_least_zero(*value)) return std::string(name) + " must not be negative";
  if (max_deviation)
    if (const auto wrong = max_deviation->problem()) return "max_deviation " + *wrong;
  if (!(min_tension_ratio >= 0 && min_tension_ratio < 1))
    return "min_tension_ratio must be at least 0 and less than 1";
  return std::nullopt;
}

double BuildSettings::length_error_in(std::string_view length_unit) const {
  return length_error.value_or(usual_length_error_mm * millimetre_in(length_unit));
}

double BuildSettings::attachment_error_in(std::string_view length_unit) const {
  return attachment_error.value_or(usual_attachment_error_mm * millimetre_in(length_unit));
}

std::optional<Gaps> BuildSettings::gaps() const {
  if (layers) return std::nullopt;
  return Gaps{.clearance = clearance, .mark_distance = mark_distance};
}

}  // namespace tencer::model
