#include "fabricate/words.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

namespace tencer::app {

std::string significant(double value) {
  constexpr int digits = 3;
  if (value == 0) return "0";
  std::array<char, 32> text;
  // As many decimals as the digits take once they are rounded.
  auto end = std::to_chars(text.data(), text.data() + text.size(), value,
                           std::chars_format::scientific, digits - 1);
  std::string rounded(text.data(), end.ptr);
  const auto exponent = rounded.find('e') + 1;
  const int power = std::stoi(rounded.substr(exponent));
  if (std::abs(value) >= 1e5 || std::abs(value) < 1e-3) {
    if (rounded[exponent + 1] == '0') rounded.erase(exponent + 1, 1);  // of "e+05"
    return rounded;
  }
  const double unit = std::pow(10.0, power - digits + 1);
  const double nearest = std::round(value / unit) * unit;
  end = std::to_chars(text.data(), text.data() + text.size(), nearest, std::chars_format::fixed,
                      std::max(0, digits - 1 - power));
  std::string number(text.data(), end.ptr);
  if (number.find('.') == std::string::npos) return number;
  number.erase(number.find_last_not_of('0') + 1);
  if (number.ends_with('.')) number.pop_back();
  return number;
}

}  // namespace tencer::app
