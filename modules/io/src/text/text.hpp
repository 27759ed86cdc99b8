// Numbers and words of text files.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <tencer/io/csv.hpp>  // to_text
#include <vector>

namespace tencer::io {

// The squares of a file's numbers must be finite, or lengths and energies are not.
inline constexpr double largest_number = 1e100;

// The whole of the text as a number; also nan and inf, which the caller refuses in its own words.
std::optional<double> to_number(std::string_view text);
std::optional<long> to_integer(std::string_view text);

// 'text'
std::string quoted(std::string_view text);

// The pieces between blanks.
std::vector<std::string_view> words(std::string_view line);

// Lines without their ends (\n or \r\n) and without a byte-order mark.
std::vector<std::string_view> lines(std::string_view text);

// For an unknown word: "did you mean X?", or the known words when none is near.
std::string suggestion(std::string_view word, std::span<const std::string_view> known);

// "use 0 to 4" for 5 things.
std::string index_range(int count);

// "a, b, c"
std::string joined(std::span<const std::string_view> parts);

}  // namespace tencer::io
