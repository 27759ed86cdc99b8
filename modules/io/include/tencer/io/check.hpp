// What a check found out about a design, for programs: its sections with lengths and forces in the
// design's units, whether it passed, and what fails.
#pragma once

#include <string>
#include <tencer/model/check.hpp>
#include <tencer/model/design.hpp>

namespace tencer::io {

// A JSON object; the file of a design that has a check holds the same under "check". Readers leave
// it alone: it holds of this file only.
std::string check_text(const model::Design& design, const model::Check& check);

}  // namespace tencer::io
