// The design as JSON, both ways.
#pragma once

#include <nlohmann/json.hpp>
#include <tencer/io/design.hpp>

#include "design/json_value.hpp"

namespace tencer::io {

inline constexpr const char* design_schema = "tencer-design/2";
inline constexpr const char* older_schema = "tencer-design/1";  // read, not written

// Throws BadInput for everything design.hpp says is checked.
model::Design design_from_json(const JsonValue& root);

nlohmann::ordered_json design_to_json(const model::Design& design);

// Points (3 x n), one array of three a point.
nlohmann::ordered_json points_to_json(const Eigen::Matrix3Xd& points);

// Of a design.
nlohmann::ordered_json check_to_json(const model::Check& check, const model::Design& design);

}  // namespace tencer::io
