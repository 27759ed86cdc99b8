#include "scene/toml_value.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdint>
#include <limits>
#include <regex>
#include <tencer/core/nearest.hpp>

#include "text/bad_input.hpp"
#include "text/text.hpp"

namespace tencer::io {
namespace {

constexpr std::size_t largest_scene = std::size_t{16} << 20;

// A value in an error message: short ones as they are, others by their kind.
std::string description(const toml::node& node) {
  if (node.is_table()) return "a table";
  if (const toml::array* array = node.as_array())
    return "an array of " + std::to_string(array->size());
  if (const auto text = node.value_exact<std::string>()) return '"' + *text + '"';
  if (const auto truth = node.value_exact<bool>()) return *truth ? "true" : "false";
  if (const auto whole = node.value_exact<std::int64_t>()) return std::to_string(*whole);
  if (const auto number = node.value_exact<double>()) return to_text(*number);
  return "a date or time";
}

std::string element(const std::string& path, std::size_t i) {
  return path + "[" + std::to_string(i) + "]";
}

// The parser recurses into keys with dots, and so do what it gives when it goes.
void check_depth(std::string_view text, const std::string& file) {
  constexpr int deepest = 50;
  int line = 1;
  int dots = 0;  // in the key that may be here
  bool after_word = false;
  for (const char c : text) {
    const bool of_word = std::isalnum(static_cast<unsigned char>(c)) || c == '_' || c == '-' ||
                         c == '"' || c == '\'';
    if (c == '\n') ++line;
    if (c == '.' && after_word) ++dots;
    if (dots > deepest)
      io::fail(file + ":" + std::to_string(line),
               "a key has more than 50 parts; no scene has such");
    if (of_word)
      after_word = true;
    else if (c == '.')
      after_word = false;
    else if (c != ' ' && c != '\t') {
      dots = 0;
      after_word = false;
    }
  }
}

std::string quoted_value(std::string_view text) {
  return std::string(1, '"').append(text).append(1, '"');
}

// Where this line, counted from 1, gives a key a bare word, that with its quotes; else empty.
std::string unquoted_text(std::string_view text, std::size_t line) {
  const auto all = lines(text);
  if (line < 1 || line > all.size()) return "";
  const std::string whole(all[line - 1]);
  static const std::regex bare(R"(\s*([\w-]+)\s*=\s*([A-Za-z/.~][^"'#\[\]{}=,]*?)\s*(#.*)?)");
  std::smatch parts;
  if (!std::regex_match(whole, parts, bare)) return "";
  return parts.str(1) + " = " + quoted_value(parts.str(2));
}

}  // namespace

toml::table TomlTable::parse(std::string_view text, const std::string& file) {
  if (text.size() > largest_scene)
    io::fail(file, "is larger than 16 MB; put the curves into files of their own");
  check_depth(text, file);
  try {
    return file.empty() ? toml::parse(text) : toml::parse(text, file);
  } catch (const toml::parse_error& error) {
    const auto line = error.source().begin.line;
    const std::string unquoted = unquoted_text(text, line);
    io::fail(file + ":" + std::to_string(line),
             unquoted.empty() ? "is not valid TOML: " + std::string(error.description())
                              : "texts are in quotes: " + unquoted);
  }
}

std::string TomlTable::place(const toml::source_region& source) {
  if (!source.path) return {};
  return *source.path + ":" + std::to_string(source.begin.line);
}

std::string TomlTable::where_of(const toml::node& node) const { return place(node.source()); }

std::string TomlTable::where(std::string_view key) const {
  const toml::node* node = table_->get(key);
  return node ? where_of(*node) : where();
}

std::string TomlTable::path_to(std::string_view key) const {
  return (path_.empty() ? "" : path_ + ".") + std::string(key);
}

void TomlTable::fail(std::string_view key, const std::string& message) const {
  io::fail(where(key), path_to(key) + ": " + message);
}

void TomlTable::fail_missing(std::string_view key) const {
  io::fail(where(), "the key " + path_to(key) + " is missing");
}

void TomlTable::expected(const toml::node& node, const std::string& path,
                         const std::string& what) const {
  io::fail(where_of(node), path + ": expected " + what + ", found " + description(node));
}

void TomlTable::only(std::span<const std::string_view> keys) const {
  for (const auto& [key, node] : *table_)
    if (std::ranges::find(keys, key.str()) == keys.end()) {
      io::fail(place(key.source()),
               "unknown key " + path_to(key.str()) + "; " + suggestion(key.str(), keys));
    }
}

std::vector<std::string> TomlTable::keys() const {
  std::vector<std::string> keys;
  for (const auto& [key, node] : *table_) keys.emplace_back(key.str());
  return keys;
}

bool TomlTable::is_array(std::string_view key) const {
  const toml::node* node = table_->get(key);
  return node && node->is_array();
}

bool TomlTable::is_array_of_arrays(std::string_view key) const {
  return is_array(key) && !table_->get_as<toml::array>(key)->empty() &&
         table_->get_as<toml::array>(key)->front().is_array();
}

bool TomlTable::is_array_of_tables(std::string_view key) const {
  return is_array(key) && !table_->get_as<toml::array>(key)->empty() &&
         table_->get_as<toml::array>(key)->front().is_table();
}

bool TomlTable::is_text(std::string_view key) const {
  const toml::node* node = table_->get(key);
  return node && node->is_string();
}

std::optional<bool> TomlTable::boolean(std::string_view key) const {
  const toml::node* node = table_->get(key);
  if (!node) return std::nullopt;
  if (!node->is_boolean()) expected(*node, path_to(key), "true or false");
  return node->as_boolean()->get();
}

std::optional<std::string> TomlTable::text(std::string_view key) const {
  const toml::node* node = table_->get(key);
  if (!node) return std::nullopt;
  if (!node->is_string()) expected(*node, path_to(key), "a text");
  return node->as_string()->get();
}

std::optional<std::string> TomlTable::one_of(std::string_view key,
                                             std::span<const std::string_view> choices) const {
  const auto value = text(key);
  if (!value || std::ranges::find(choices, *value) != choices.end()) return value;
  const std::string_view meant = core::nearest(*value, choices);
  fail(key, "expected one of " + joined(choices) + ", found " + quoted_value(*value) +
                (meant.empty() ? "" : "; did you mean " + quoted_value(meant) + "?"));
}

double TomlTable::finite(const toml::node& node, const std::string& path) const {
  const auto value = node.is_number() ? node.value<double>() : std::nullopt;
  if (!value) expected(node, path, "a number");
  if (!std::isfinite(*value)) expected(node, path, "a finite number");
  if (std::abs(*value) > largest_number) expected(node, path, "a number of at most 1e100");
  return *value;
}

int TomlTable::integer(const toml::node& node, const std::string& path) const {
  if (!node.is_integer()) expected(node, path, "a whole number");
  const auto value = node.as_integer()->get();
  if (value < 0 || value > std::numeric_limits<int>::max())
    expected(node, path, "a whole number from 0");
  return static_cast<int>(value);
}

std::optional<double> TomlTable::number(std::string_view key) const {
  const toml::node* node = table_->get(key);
  if (!node) return std::nullopt;
  return finite(*node, path_to(key));
}

std::optional<double> TomlTable::positive(std::string_view key) const {
  const auto value = number(key);
  if (value && *value <= 0) expected(*table_->get(key), path_to(key), "a positive number");
  return value;
}

std::optional<double> TomlTable::at_least_zero(std::string_view key) const {
  const auto value = number(key);
  if (value && *value < 0)
    expected(*table_->get(key), path_to(key), "a number that is not negative");
  return value;
}

std::optional<int> TomlTable::integer(std::string_view key, int least, int most) const {
  const toml::node* node = table_->get(key);
  if (!node) return std::nullopt;
  const int value = integer(*node, path_to(key));
  if (value < least) expected(*node, path_to(key), "a whole number from " + std::to_string(least));
  if (value > most)
    expected(*node, path_to(key), "a whole number of at most " + std::to_string(most));
  return value;
}

const toml::array* TomlTable::array(std::string_view key, const std::string& what) const {
  const toml::node* node = table_->get(key);
  if (node && !node->is_array()) expected(*node, path_to(key), what);
  return node ? node->as_array() : nullptr;
}

std::optional<std::vector<double>> TomlTable::numbers(std::string_view key) const {
  const toml::array* list = array(key, "an array of numbers");
  if (!list) return std::nullopt;
  std::vector<double> result;
  for (const toml::node& node : *list)
    result.push_back(finite(node, element(path_to(key), result.size())));
  return result;
}

std::optional<std::vector<int>> TomlTable::integers(std::string_view key) const {
  const toml::array* list = array(key, "an array of whole numbers");
  if (!list) return std::nullopt;
  std::vector<int> result;
  for (const toml::node& node : *list)
    result.push_back(integer(node, element(path_to(key), result.size())));
  return result;
}

std::optional<std::vector<std::vector<int>>> TomlTable::integer_lists(std::string_view key) const {
  const toml::array* lists = array(key, "an array of arrays of whole numbers");
  if (!lists) return std::nullopt;
  std::vector<std::vector<int>> result;
  for (const toml::node& node : *lists) {
    const std::string path = element(path_to(key), result.size());
    if (!node.is_array()) expected(node, path, "an array of whole numbers");
    std::vector<int> inner;
    for (const toml::node& item : *node.as_array())
      inner.push_back(integer(item, element(path, inner.size())));
    result.push_back(std::move(inner));
  }
  return result;
}

Eigen::Vector3d TomlTable::point(const toml::node& node, const std::string& path) const {
  const toml::array* list = node.as_array();
  if (!list || list->size() != 3) expected(node, path, "a point [x, y, z]");
  Eigen::Vector3d result;
  for (std::size_t axis = 0; axis < 3; ++axis)
    result[static_cast<Eigen::Index>(axis)] = finite((*list)[axis], element(path, axis));
  return result;
}

std::optional<Eigen::Vector3d> TomlTable::point(std::string_view key) const {
  const toml::node* node = table_->get(key);
  if (!node) return std::nullopt;
  return point(*node, path_to(key));
}

std::optional<Eigen::Matrix3Xd> TomlTable::points(std::string_view key) const {
  const toml::array* list = array(key, "an array of points [x, y, z]");
  if (!list) return std::nullopt;
  Eigen::Matrix3Xd result(3, list->size());
  for (std::size_t i = 0; i < list->size(); ++i)
    result.col(i) = point((*list)[i], element(path_to(key), i));
  return result;
}

std::optional<TomlTable> TomlTable::table(std::string_view key) const {
  const toml::node* node = table_->get(key);
  if (!node) return std::nullopt;
  if (!node->is_table()) expected(*node, path_to(key), "a table");
  return TomlTable(*node->as_table(), path_to(key));
}

std::vector<TomlTable> TomlTable::tables(std::string_view key) const {
  std::vector<TomlTable> result;
  if (const toml::node* node = table_->get(key); node && node->is_table())
    fail(key, "is one table, where there may be several; write [[" + path_to(key) + "]] for [" +
                  path_to(key) + "]");
  if (const toml::array* list = array(key, "an array of tables"))
    for (const toml::node& node : *list) {
      const std::string path = element(path_to(key), result.size());
      if (!node.is_table()) expected(node, path, "a table");
      result.push_back(TomlTable(*node.as_table(), path));
    }
  return result;
}

}  // namespace tencer::io
