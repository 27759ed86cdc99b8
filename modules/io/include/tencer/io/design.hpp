// The design file, design.json, schema "tencer-design/2": a designed structure and what is known of
// it, in the file's own units. "tencer-design/1" is read too: its rods say no section and material.
// So are designs of the paper: published models, and the states that its own program saves
// (docs/curves.md has their keys). Their numbers are taken as cm and N.
//
// A rod has its stiffnesses EA, EI, GJ, and where they are known its section ("shape" and sizes),
// its material (youngs_modulus in Pa, density in kg/m^3, strains as fractions) and the largest
// bending strain of its pose. "shortfalls" are written for readers: why the design is not complete.
// In the file a matrix of points is an array of n triples; a cable's end is {"rod", "s"} (arc
// length at rest, in [0, length of the rod]) or {"anchor"}; length and tension are those of the
// inextensible cable at the pose, and a cable that can be simulated as a spring also has a
// stiffness (force per length) and a rest length, both or neither.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <tencer/core/error.hpp>
#include <tencer/model/design.hpp>

namespace tencer::io {

// Keys that are not there mean none (anchors, pins, loads, ...). Keys that are not of the schema
// are left alone: other programs may add theirs. Everything else is checked: sizes, indices, finite
// numbers, s in [0, length], positive stiffnesses and lengths. Errors: "file: key", such as
// "design.json: rods[1].rest_lengths".
core::Expected<model::Design> read_design(const std::filesystem::path& path);

// The text of the file, unchecked. All doubles round-trip.
std::string design_text(const model::Design& design);

// What read_design would refuse in the design's text; errors name `path`, which is not touched.
[[nodiscard]] std::optional<core::Error> design_problem(const std::filesystem::path& path,
                                                        const model::Design& design);

// Makes these checks first, so that no file is written that read_design refuses.
[[nodiscard]] std::optional<core::Error> write_design(const std::filesystem::path& path,
                                                      const model::Design& design);

// "complete", "tolerance-not-reached", "interrupted".
const char* status_name(model::DesignStatus status);

}  // namespace tencer::io
