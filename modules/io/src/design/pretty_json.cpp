#include "design/pretty_json.hpp"

#include <algorithm>

namespace tencer::io {
namespace {

constexpr std::size_t line_width = 100;

// A name taken from a file's name need not be UTF-8; JSON must be.
std::string one_line(const nlohmann::ordered_json& value) {
  return value.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
}

bool on_one_line(const nlohmann::ordered_json& value) {
  if (!value.is_structured() || value.empty()) return true;
  if (value.is_array())
    return std::ranges::none_of(value, [](const auto& item) { return item.is_structured(); });
  return one_line(value).size() <= line_width;
}

void append(std::string& text, const nlohmann::ordered_json& value, std::size_t indent) {
  if (on_one_line(value)) {
    text += one_line(value);
    return;
  }
  const std::string margin(indent + 1, ' ');
  const bool array = value.is_array();
  text += array ? "[" : "{";
  const char* separator = "\n";
  for (const auto& [key, item] : value.items()) {
    text += separator + margin;
    if (!array) text += one_line(key) + ": ";
    append(text, item, indent + 1);
    separator = ",\n";
  }
  text.append(1, '\n').append(indent, ' ').append(1, array ? ']' : '}');
}

}  // namespace

std::string pretty(const nlohmann::ordered_json& value) {
  std::string text;
  append(text, value, 0);
  return text + "\n";
}

}  // namespace tencer::io
