// Tables of texts as CSV (RFC 4180): fields with commas, quotes or line ends are quoted.
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <tencer/core/error.hpp>
#include <vector>

namespace tencer::io {

using CsvRow = std::vector<std::string>;

// The shortest text that reads back as the same double.
std::string to_text(double number);

// The row with its line end.
std::string csv_line(std::span<const std::string> fields);

// The rows of a text; `path` only names it in errors: "file:line" when a quote is not closed or is
// followed by something else than a comma.
core::Expected<std::vector<CsvRow>> parse_csv(const std::filesystem::path& path,
                                              std::string_view text);

}  // namespace tencer::io
