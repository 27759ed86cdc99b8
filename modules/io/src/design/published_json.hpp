// Designs of the paper as JSON: one published model, and what the paper's own program saves. Both
// are in no unit that they tell; cm and N are taken. Their cables are springs, built as long as
// they are in the published pose.
#pragma once

#include <tencer/model/design.hpp>
#include <vector>

#include "design/json_value.hpp"

namespace tencer::io {

// {"name", "rods": [{"closed", "youngs_modulus", "radius", "rest_lengths", "target",
// "published_equilibrium"}], "anchors", "cables": [{"a", "b", "stiffness", "rest_length"}]}. Rods
// are round and straight at rest. Throws BadInput, as the next does.
bool is_published(const nlohmann::json& content);
model::Design design_from_published(const JsonValue& root);

// The state of the paper's program (its save_to_json): open rods first, each with its own target
// and equilibrium as a list of unknowns. An open rod that stands exactly in its target while cables
// pull at its vertices is the frame that the program has no other word for: it becomes anchors.
bool is_program_state(const nlohmann::json& content);
model::Design design_from_program_state(const JsonValue& root);

// The section of both, of an inscribed polygon of 1000 sides instead of a circle: EA smaller by
// 6.6e-6, EI and GJ by 1.3e-5. Stored equilibria are those of these stiffnesses.
// Fails at the radius where that makes stiffnesses that no rod has.
der::Section published_section(const JsonValue& youngs_modulus, const JsonValue& radius);

// Whether they all lie in one plane z = const.
bool are_flat(const std::vector<Eigen::Matrix3Xd>& rods);

// Builds the cables in the design's pose; where their two ends meet or a tension overflows,
// `cables` fails.
void build_in_pose(model::Design& design, const JsonValue& cables);

}  // namespace tencer::io
