// What is recorded of a study's runs: a table of one line for each, beside its design and its log.
// A run's record is written by whoever made it and by nobody else, so many programs may make runs
// in one folder.
#pragma once

#include "table.hpp"

namespace tencer::app::study {

// In the study's folder: the design of a run, what was printed as it was made, and its record.
std::filesystem::path design_of(const std::filesystem::path& folder, const Run& run);
std::filesystem::path log_of(const std::filesystem::path& folder, const Run& run);
std::filesystem::path record_of(const std::filesystem::path& folder, const Run& run);

// None where the run has not been made. Error: the record is of another file of the same name, or
// none.
core::Expected<std::optional<Row>> recorded(const Run& run, const std::filesystem::path& folder);

// There is the whole record or none, and then the old one, whatever becomes of this program.
std::optional<core::Error> record(const Row& row, const std::filesystem::path& folder);

// The rows of all records, by scene, method, optimizer, resolution and max error.
core::Expected<std::vector<Row>> all_records(const std::filesystem::path& folder);

}  // namespace tencer::app::study
