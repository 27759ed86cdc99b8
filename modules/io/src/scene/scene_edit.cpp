#include "scene/scene_edit.hpp"

#include <tencer/io/design.hpp>
#include <utility>

namespace tencer::io {
namespace {

model::Design design_from(const TomlTable& edit, const std::filesystem::path& folder,
                          std::span<const model::Design> designs) {
  if (!designs.empty() && !edit.is_text("from"))
    return designs[edit.need("from",
                             edit.integer("from", 0, static_cast<int>(designs.size()) - 1))];
  const std::string file = edit.need("from", edit.text("from"));
  auto design = read_design(folder / file);
  if (!design) edit.fail("from", design.error().text());
  return std::move(*design);
}

}  // namespace

model::Edit read_edit(const TomlTable& edit, const std::filesystem::path& folder,
                      std::span<const model::Design> designs) {
  edit.only({"from", "keep", "forbid", "add", "remove"});
  return {.from = design_from(edit, folder, designs),
          .keep = edit.integers("keep").value_or(std::vector<int>{}),
          .forbid = edit.integers("forbid").value_or(std::vector<int>{}),
          .add = edit.integer("add", 1),
          .remove = edit.integer("remove", 1)};
}

}  // namespace tencer::io
