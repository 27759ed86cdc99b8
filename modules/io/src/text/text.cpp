#include "text/text.hpp"

#include <algorithm>
#include <charconv>
#include <tencer/core/nearest.hpp>

namespace tencer::io {
namespace {

template <class T>
std::optional<T> parse_all(std::string_view text) {
  if (text.starts_with('+') && !text.starts_with("+-")) text.remove_prefix(1);
  T value{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (text.empty() || error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return value;
}

}  // namespace

std::optional<double> to_number(std::string_view text) { return parse_all<double>(text); }

std::optional<long> to_integer(std::string_view text) { return parse_all<long>(text); }

std::string to_text(double number) {
  char buffer[32];
  const auto result = std::to_chars(buffer, buffer + sizeof buffer, number);
  return {buffer, result.ptr};
}

std::string quoted(std::string_view text) {
  return std::string(1, '\'').append(text).append(1, '\'');
}

std::vector<std::string_view> words(std::string_view line) {
  constexpr std::string_view blanks = " \t\r\v\f";
  std::vector<std::string_view> result;
  for (std::size_t at = line.find_first_not_of(blanks); at != std::string_view::npos;) {
    const std::size_t end = std::min(line.find_first_of(blanks, at), line.size());
    result.push_back(line.substr(at, end - at));
    at = line.find_first_not_of(blanks, end);
  }
  return result;
}

std::vector<std::string_view> lines(std::string_view text) {
  if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);
  std::vector<std::string_view> result;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    std::string_view line = text.substr(0, end);
    if (line.ends_with('\r')) line.remove_suffix(1);
    result.push_back(line);
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return result;
}

std::string suggestion(std::string_view word, std::span<const std::string_view> known) {
  const std::string_view best = core::nearest(word, known);
  return best.empty() ? "known here: " + joined(known) : "did you mean " + std::string(best) + "?";
}

std::string index_range(int count) {
  if (count == 0) return "there are none";
  return count == 1 ? "use 0" : "use 0 to " + std::to_string(count - 1);
}

std::string joined(std::span<const std::string_view> parts) {
  std::string result;
  for (const std::string_view part : parts) {
    if (!result.empty()) result += ", ";
    result += part;
  }
  return result;
}

}  // namespace tencer::io
