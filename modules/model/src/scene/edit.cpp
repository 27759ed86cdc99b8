#include <algorithm>
#include <set>
#include <tencer/model/edit.hpp>

namespace tencer::model {
namespace {

std::optional<std::string> numbers_problem(const char* field, const std::vector<int>& numbers,
                                           int cables) {
  for (const int number : numbers)
    if (number < 1 || number > cables)
      return std::string(field) + ": there is no cable " + std::to_string(number) +
             "; the design has cables 1 to " + std::to_string(cables);
  return std::nullopt;
}

}  // namespace

std::optional<std::string> Edit::problem() const {
  const auto count = static_cast<int>(from.structure.cables.size());
  if (count == 0) return "from: the design has no cables to go on from";
  for (const auto& wrong :
       {numbers_problem("keep", keep, count), numbers_problem("forbid", forbid, count)})
    if (wrong) return wrong;
  for (const int number : keep)
    if (std::ranges::count(forbid, number) > 0)
      return "forbid: cable " + std::to_string(number) + " is also to be kept";
  if (add && remove) return "remove: give either add or remove";
  if (add && *add < 1) return "add: must be at least 1";
  if (remove && *remove < 1) return "remove: must be at least 1";
  const int least = std::max(1, static_cast<int>(keep.size()));
  if (remove && cables() < least)
    return "remove: of " + std::to_string(count) + " cables at least " + std::to_string(least) +
           " stay, so at most " + std::to_string(*cables() + *remove - least) + " can go";
  return std::nullopt;
}

std::optional<int> Edit::cables() const {
  if (!add && !remove) return std::nullopt;
  const std::set<int> gone(forbid.begin(), forbid.end());
  const auto left = static_cast<int>(from.structure.cables.size() - gone.size());
  return left + add.value_or(0) - remove.value_or(0);
}

}  // namespace tencer::model
