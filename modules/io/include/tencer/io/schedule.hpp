// The schedule file, TOML: how the cables of a design are pulled and let go. docs/actuate.md
// describes it.
#pragma once

#include <filesystem>
#include <string>
#include <tencer/core/error.hpp>
#include <tencer/model/schedule.hpp>

namespace tencer::io {

// For this design, whose unit of length is one of model::length_units(). Errors: "file:line", with
// the key: a cable that the design has not, a length that is none, or not positive.
core::Expected<model::Schedule> read_schedule(const std::filesystem::path& path,
                                              const model::Design& design);

// The same of TOML in memory. Errors name the key alone.
core::Expected<model::Schedule> schedule_of_text(const std::string& text,
                                                 const model::Design& design);

}  // namespace tencer::io
