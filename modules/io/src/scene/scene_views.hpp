// The views of a scene: from where its target has to look right.
#pragma once

#include <tencer/model/view.hpp>
#include <vector>

#include "scene/toml_value.hpp"

namespace tencer::io {

// The key `view` of [design], which is there: a direction, a list of them, or tables with a weight
// each.
std::vector<model::View> read_views(const TomlTable& design, bool planar);

}  // namespace tencer::io
