// What may be asked of a picture.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace tencer::app {

// The sides of a structure: the front shows most of it, see axes.hpp.
enum class View { front, side, top, oblique };

std::string name_of(View view);
std::optional<View> view_named(std::string_view name);
std::vector<std::string> view_names();

struct PictureOptions {
  std::vector<View> views{};  // none: oblique, or the front of what is flat
  std::string caption{};
  bool numbers = true;  // of cables
};

}  // namespace tencer::app
