#include "edit_input.hpp"

#include <tencer/io/design.hpp>
#include <utility>

#include "command.hpp"

namespace tencer::app {

void add_edit(CLI::App& command, EditRequest& request) {
  command.add_option("--from", request.from,
                     "Go on from this design.json, in a fraction of the time of a search");
  command
      .add_option("--keep", request.keep,
                  "Cables of that design that stay as they are, by number: 1,4")
      ->delimiter(',')
      ->check(positive_integer());
  command
      .add_option("--forbid", request.forbid,
                  "Cables of that design that go, and none like them comes: 2,3")
      ->delimiter(',')
      ->check(positive_integer());
  command.add_option("--add", request.add, "So many cables more than that design")
      ->check(positive_integer());
  command.add_option("--remove", request.remove, "So many cables fewer than that design")
      ->check(positive_integer());
}

std::optional<core::Error> apply(const EditRequest& request, bool cables_given,
                                 model::Scene& scene) {
  if (request.from.empty() && !scene.edit) {
    for (const auto& [given, option] : {std::pair(!request.keep.empty(), "--keep"),
                                        std::pair(!request.forbid.empty(), "--forbid"),
                                        std::pair(request.add.has_value(), "--add"),
                                        std::pair(request.remove.has_value(), "--remove")})
      if (given)
        return core::Error{option, "says what is made of another design; name it with --from"};
    return std::nullopt;
  }
  if (!request.from.empty()) {
    auto design = io::read_design(request.from);
    if (!design) return design.error();
    scene.edit.emplace().from = std::move(*design);
  }
  model::Edit& edit = *scene.edit;
  if (!request.keep.empty()) edit.keep = request.keep;
  if (!request.forbid.empty()) edit.forbid = request.forbid;
  if (request.add || request.remove) {
    edit.add = request.add;
    edit.remove = request.remove;
    if (!cables_given) scene.design.cables.reset();
  }
  return std::nullopt;
}

}  // namespace tencer::app
