#include <algorithm>
#include <charconv>
#include <cmath>
#include <tencer/model/allowance.hpp>
#include <tencer/model/units.hpp>

namespace tencer::model {

std::optional<std::string> Allowance::problem() const {
  const bool known = unit == "%" || std::ranges::count(length_units(), std::string_view(unit)) > 0;
  if (known && amount > 0 && std::isfinite(amount)) return std::nullopt;
  return "must be a positive number, in %, mm, cm or m";
}

double Allowance::length(std::string_view length_unit, double size) const {
  if (unit == "%") return amount / 100 * size;
  return amount * metres(unit) / metres(length_unit);
}

std::optional<Allowance> read_allowance(std::string_view text) {
  Allowance result;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), result.amount);
  if (error != std::errc()) return std::nullopt;
  text.remove_prefix(static_cast<std::size_t>(end - text.data()));
  if (const auto first = text.find_first_not_of(' '); first != std::string_view::npos)
    result.unit = text.substr(first);
  return result.problem() ? std::nullopt : std::optional(result);
}

}  // namespace tencer::model
