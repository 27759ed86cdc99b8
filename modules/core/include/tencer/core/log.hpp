// The log port: how a library says something without printing. An empty Log is silent.
#pragma once

#include <functional>
#include <string_view>

namespace tencer::core {

enum class Level { debug, info, warning };

using Log = std::function<void(Level, std::string_view)>;

}  // namespace tencer::core
