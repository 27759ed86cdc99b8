// A result in short, for programs: one JSON object with the names that its file has.
#pragma once

#include <span>
#include <string>
#include <tencer/model/design.hpp>
#include <tencer/model/feasibility.hpp>
#include <variant>
#include <vector>

namespace tencer::io {

// What a file does not say of its own: "seconds", "folder".
struct NamedValue {
  std::string name;
  std::variant<double, std::string, bool> value;
};

// What design.json says, but for rods, supports, loads and the record of the search, with `beside`
// at its end; designs of other numbers of cables are, likewise, the array "trade_off".
std::string summary_text(const model::Design& design, const std::vector<NamedValue>& beside = {},
                         std::span<const model::Design> trade_off = {});

// What feasible.json says, but for the rods.
std::string summary_text(const model::Feasibility& feasibility);

}  // namespace tencer::io
