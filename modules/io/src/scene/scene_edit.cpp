#include "scene/scene_edit.hpp"

#include <tencer/io/design.hpp>
#include <utility>

namespace tencer::io {

model::Edit read_edit(const TomlTable& edit, const std::filesystem::path& folder) {
  edit.only({"from", "keep", "forbid", "add", "remove"});
  const std::string file = edit.need("from", edit.text("from"));
  auto design = read_design(folder / file);
  if (!design) edit.fail("from", design.error().text());
  return {.from = std::move(*design),
          .keep = edit.integers("keep").value_or(std::vector<int>{}),
          .forbid = edit.integers("forbid").value_or(std::vector<int>{}),
          .add = edit.integer("add", 1),
          .remove = edit.integer("remove", 1)};
}

}  // namespace tencer::io
