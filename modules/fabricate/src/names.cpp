#include <array>
#include <charconv>
#include <cmath>
#include <tencer/core/names.hpp>
#include <tencer/fabricate/names.hpp>

namespace tencer::fabricate {

std::string end_name(const springs::End& end) {
  if (const auto* anchor = std::get_if<springs::AtAnchor>(&end))
    return core::anchor_name(anchor->anchor);
  const auto& on = std::get<springs::OnRod>(end);
  return core::rod_name(on.rod) + ' ' + tenths(on.s);
}

std::string tenths(double mm) {
  std::array<char, 400> text;                                // the largest double has 309 digits
  const double rounded = std::round(10 * mm) == 0 ? 0 : mm;  // no -0.0
  const auto end =
      std::to_chars(text.data(), text.data() + text.size(), rounded, std::chars_format::fixed, 1);
  return {text.data(), end.ptr};
}

}  // namespace tencer::fabricate
