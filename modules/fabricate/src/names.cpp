#include <array>
#include <charconv>
#include <cmath>
#include <tencer/core/error.hpp>
#include <tencer/fabricate/names.hpp>

namespace tencer::fabricate {

std::string rod_name(int rod) {
  core::require(rod >= 0, "rod_name: a rod's index is not negative");
  const std::string last(1, static_cast<char>('A' + rod % 26));
  return rod < 26 ? last : rod_name(rod / 26 - 1) + last;
}

std::string cable_name(int cable) { return std::to_string(cable + 1); }

std::string anchor_name(int anchor) { return "anchor " + std::to_string(anchor + 1); }

std::string end_name(const springs::End& end) {
  if (const auto* anchor = std::get_if<springs::AtAnchor>(&end)) return anchor_name(anchor->anchor);
  const auto& on = std::get<springs::OnRod>(end);
  return rod_name(on.rod) + ' ' + tenths(on.s);
}

std::string tenths(double mm) {
  std::array<char, 400> text;                                // the largest double has 309 digits
  const double rounded = std::round(10 * mm) == 0 ? 0 : mm;  // no -0.0
  const auto end =
      std::to_chars(text.data(), text.data() + text.size(), rounded, std::chars_format::fixed, 1);
  return {text.data(), end.ptr};
}

}  // namespace tencer::fabricate
