// The design as JSON, both ways, and the other files that are read as one. Every key that is
// written is in docs/design.schema.json, which a test validates files by.
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string_view>
#include <tencer/io/design.hpp>

#include "design/json_value.hpp"

namespace tencer::io {

inline constexpr const char* design_schema = "tencer-design/2";
inline constexpr const char* older_schema = "tencer-design/1";  // read, not written

inline constexpr std::string_view axis_names = "xyz";  // as pins have them

// Throws BadInput for everything design.hpp says is checked.
model::Design design_from_json(const JsonValue& root);

// Whether this is meant to be a design, of this program or of the paper (published_json.hpp); and
// that design, named after the file where it says no name.
bool is_design(const nlohmann::json& content);
model::Design any_design(const JsonValue& root, const std::filesystem::path& path);

nlohmann::ordered_json design_to_json(const model::Design& design);

nlohmann::ordered_json at_least_to_json(const model::AtLeast& at_least);

// Points (3 x n), one array of three a point.
nlohmann::ordered_json points_to_json(const Eigen::Matrix3Xd& points);

// Rounded to what is seen.
nlohmann::ordered_json snapshots_to_json(const std::vector<model::Snapshot>& snapshots);
std::vector<model::Snapshot> read_snapshots(const JsonValue& list);

// Of a design.
nlohmann::ordered_json check_to_json(const model::Check& check, const model::Design& design);

}  // namespace tencer::io
