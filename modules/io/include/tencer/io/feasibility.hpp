// Whether a shape can be held, for programs: the verdict, the motion that proves it, what was
// tried.
#pragma once

#include <string>
#include <tencer/model/feasibility.hpp>

namespace tencer::io {

// A JSON object. Lengths are in length_unit; `motion` has one entry a vertex of `target`.
std::string feasibility_text(const model::Feasibility& feasibility);

}  // namespace tencer::io
