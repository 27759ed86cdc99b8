// The record of error against run time as a CSV table.
#pragma once

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <tencer/core/error.hpp>
#include <tencer/model/stage_row.hpp>

namespace tencer::io {

// A header line and one line a row: commas, quotes as in RFC 4180, doubles that round-trip, empty
// fields for errors that a stage does not have.
std::string trace_text(std::span<const model::StageRow> rows);
[[nodiscard]] std::optional<core::Error> write_trace(const std::filesystem::path& path,
                                                     std::span<const model::StageRow> rows);

}  // namespace tencer::io
