// The text of a design file as JSON.
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>

namespace tencer::io {

// The content of a file that is to hold a design. Throws BadInput, for curves and scenes with what
// to do with them.
nlohmann::json parse_design(const std::filesystem::path& path);

}  // namespace tencer::io
