#include <algorithm>
#include <charconv>
#include <cmath>
#include <tencer/core/error.hpp>
#include <tencer/model/schedule.hpp>
#include <tencer/model/units.hpp>

namespace tencer::model {
namespace {

std::string_view without_blanks(std::string_view text) {
  const auto first = text.find_first_not_of(' ');
  return first == std::string_view::npos ? std::string_view() : text.substr(first);
}

}  // namespace

double LengthChange::apply(double before, double in_design, std::string_view length_unit) const {
  const double length =
      unit == "%" ? amount / 100 * in_design : amount * metres(unit) / metres(length_unit);
  return by ? before + length : length;
}

std::optional<LengthChange> read_length_change(std::string_view text) {
  LengthChange result;
  text = without_blanks(text);
  if (text.starts_with("by "))
    result.by = true;
  else if (!text.starts_with("to "))
    return std::nullopt;
  text = without_blanks(text.substr(3));
  if (text.starts_with('+')) text.remove_prefix(1);
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), result.amount);
  if (error != std::errc() || !std::isfinite(result.amount)) return std::nullopt;
  result.unit = without_blanks(text.substr(static_cast<std::size_t>(end - text.data())));
  const bool known = result.unit == "%" || std::ranges::count(length_units(), result.unit) > 0;
  return known ? std::optional(result) : std::nullopt;
}

std::vector<Eigen::VectorXd> lengths_of(const Schedule& schedule, const Design& design) {
  Eigen::VectorXd lengths(static_cast<Eigen::Index>(design.built.size()));
  for (std::size_t c = 0; c < design.built.size(); ++c)
    lengths[static_cast<Eigen::Index>(c)] = design.built[c].length;
  std::vector<Eigen::VectorXd> result;
  for (const ScheduleStep& step : schedule.steps) {
    core::require(step.changes.size() == design.built.size(),
                  "lengths_of: every step needs an entry for every cable");
    for (std::size_t c = 0; c < step.changes.size(); ++c) {
      double& length = lengths[static_cast<Eigen::Index>(c)];
      if (step.changes[c])
        length = step.changes[c]->apply(length, design.built[c].length, design.length_unit);
    }
    result.push_back(lengths);
  }
  return result;
}

}  // namespace tencer::model
