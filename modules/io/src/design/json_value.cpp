#include "design/json_value.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "text/bad_input.hpp"
#include "text/text.hpp"

namespace tencer::io {
namespace {

// A value in an error message: short ones as they are, others by their kind.
std::string description(const nlohmann::json& value) {
  if (value.is_array()) return "an array of " + std::to_string(value.size());
  if (value.is_object()) return "an object";
  return value.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

// The library's message without its prefix, "[identifier] parse error at line 3, column 7: ".
std::string parse_message(const std::string& what) {
  const std::size_t start = what.find("] ") + 2;
  const std::size_t position = what.find(": ", start);
  return what.substr(position == std::string::npos ? start : position + 2);
}

}  // namespace

nlohmann::json JsonValue::parse(std::string_view text, const std::string& file) {
  try {
    return nlohmann::json::parse(text);
  } catch (const nlohmann::json::parse_error& error) {
    const std::size_t end = std::min(error.byte, text.size());
    const auto line =
        1 + std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(end), '\n');
    io::fail(file + ":" + std::to_string(line),
             "is not valid JSON: " + parse_message(error.what()));
  } catch (const nlohmann::json::exception& error) {
    io::fail(file, "is not valid JSON: " + parse_message(error.what()));
  }
}

void JsonValue::fail(const std::string& message) const { io::fail(where(), message); }

void JsonValue::expected(const std::string& what) const {
  fail("expected " + what + ", found " + description(*value_));
}

bool JsonValue::has(std::string_view key) const {
  if (!value_->is_object()) expected("an object");
  return value_->contains(key);
}

JsonValue JsonValue::operator[](std::string_view key) const {
  if (!has(key)) fail("the key \"" + std::string(key) + "\" is missing");
  return {value_->find(key).value(), file_, (path_.empty() ? "" : path_ + ".") + std::string(key)};
}

std::vector<JsonValue> JsonValue::items() const {
  if (!value_->is_array()) expected("an array");
  std::vector<JsonValue> result;
  for (std::size_t i = 0; i < value_->size(); ++i)
    result.push_back({(*value_)[i], file_, path_ + "[" + std::to_string(i) + "]"});
  return result;
}

bool JsonValue::boolean() const {
  if (!value_->is_boolean()) expected("true or false");
  return value_->get<bool>();
}

std::string JsonValue::text() const {
  if (!value_->is_string()) expected("a text");
  return value_->get<std::string>();
}

double JsonValue::number() const {
  if (!value_->is_number()) expected("a number");
  const double result = value_->get<double>();
  if (!std::isfinite(result)) expected("a finite number");
  if (std::abs(result) > largest_number) expected("a number of at most 1e100");
  return result;
}

double JsonValue::positive() const {
  if (number() <= 0) expected("a positive number");
  return number();
}

double JsonValue::at_least_zero() const {
  if (number() < 0) expected("a number that is not negative");
  return number();
}

int JsonValue::integer(int least) const {
  if (!value_->is_number_integer()) expected("a whole number");
  const auto result = value_->get<std::int64_t>();
  if (result < least || result > std::numeric_limits<int>::max())
    expected("a whole number from " + std::to_string(least));
  return static_cast<int>(result);
}

int JsonValue::index(int size, std::string_view of) const {
  const int result = integer(0);
  if (result >= size)
    fail("there is no " + std::string(of) + " " + std::to_string(result) + "; " +
         index_range(size));
  return result;
}

Eigen::Vector3d JsonValue::point() const {
  if (!value_->is_array() || value_->size() != 3) expected("a point [x, y, z]");
  const std::vector<JsonValue> coordinates = items();
  return {coordinates[0].number(), coordinates[1].number(), coordinates[2].number()};
}

Eigen::Matrix3Xd JsonValue::points() const {
  const std::vector<JsonValue> columns = items();
  Eigen::Matrix3Xd result(3, columns.size());
  for (std::size_t i = 0; i < columns.size(); ++i) result.col(i) = columns[i].point();
  return result;
}

Eigen::VectorXd JsonValue::numbers() const {
  const std::vector<JsonValue> values = items();
  Eigen::VectorXd result(values.size());
  for (std::size_t i = 0; i < values.size(); ++i) result[i] = values[i].number();
  return result;
}

}  // namespace tencer::io
