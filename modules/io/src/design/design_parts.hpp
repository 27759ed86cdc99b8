// What design files of all programs hold alike: shapes of rods, places of cables.
#pragma once

#include <Eigen/Core>
#include <string>
#include <tencer/model/design.hpp>

#include "design/json_value.hpp"

namespace tencer::io {

// Fails unless `found` of them are expected.
void check_count(const JsonValue& value, long found, long expected, const std::string& what);

// A rod's target or pose (3 x n), which a rod can follow.
Eigen::Matrix3Xd read_shape(const JsonValue& value, bool closed);

// The "s" of a place on the rod.
double read_arc_length(const JsonValue& value, const der::Rod& rod);

// {"rod", "s"} or {"anchor"} of the structure's rods and anchors.
springs::End read_end(const JsonValue& value, const model::Structure& structure);

}  // namespace tencer::io
