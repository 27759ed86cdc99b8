#include "drawing/picture_options.hpp"

#include <algorithm>
#include <array>
#include <utility>

namespace tencer::app {
namespace {

constexpr std::array<std::pair<std::string_view, View>, 4> named{
    {{"front", View::front}, {"side", View::side}, {"top", View::top}, {"oblique", View::oblique}}};

}  // namespace

std::string name_of(View view) {
  return std::string(
      std::ranges::find(named, view, &std::pair<std::string_view, View>::second)->first);
}

std::optional<View> view_named(std::string_view name) {
  const auto* one = std::ranges::find(named, name, &std::pair<std::string_view, View>::first);
  return one == named.end() ? std::nullopt : std::optional(one->second);
}

std::vector<std::string> view_names() {
  std::vector<std::string> names;
  for (const auto& [name, view] : named) names.emplace_back(name);
  return names;
}

}  // namespace tencer::app
