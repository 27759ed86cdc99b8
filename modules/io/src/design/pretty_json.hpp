// JSON laid out for people: one line for an array of plain values or a small object, so that a
// point is a line.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

namespace tencer::io {

// With a line end at the end. Doubles round-trip; numbers must be finite.
std::string pretty(const nlohmann::ordered_json& value);

}  // namespace tencer::io
