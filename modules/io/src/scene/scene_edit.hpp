// The [edit] table of a scene: the design that another is made from.
#pragma once

#include <filesystem>
#include <span>
#include <tencer/model/edit.hpp>

#include "scene/toml_value.hpp"

namespace tencer::io {

// folder: what the path of the design is relative to; designs: those that it may name by their
// number.
model::Edit read_edit(const TomlTable& edit, const std::filesystem::path& folder,
                      std::span<const model::Design> designs);

}  // namespace tencer::io
