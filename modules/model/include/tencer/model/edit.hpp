// A design that another is made from: what is to stay of it, what is to go.
#pragma once

#include <optional>
#include <string>
#include <tencer/model/design.hpp>
#include <vector>

namespace tencer::model {

// Cables by their numbers, from 1, as on the page, the picture and the sheet of `from`.
struct Edit {
  Design from{};
  std::vector<int> keep{};    // stay as they are: marks and length
  std::vector<int> forbid{};  // go, and none that is like them comes
  // So many cables more or fewer than are left then, and the closest design with as many. Not set:
  // as the settings say.
  std::optional<int> add = std::nullopt;
  std::optional<int> remove = std::nullopt;

  // What is wrong, beginning with the name of the field; not set: nothing.
  std::optional<std::string> problem() const;

  // How many cables are asked for; not set: as the settings say.
  std::optional<int> cables() const;
};

}  // namespace tencer::model
