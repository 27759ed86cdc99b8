// A place in a JSON file: the value and the key path that leads to it, for errors such as
// "design.json: rods[1].rest_lengths: expected 102 numbers, found 101".
#pragma once

#include <Eigen/Core>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace tencer::io {

class JsonValue {
 public:
  // The whole file; throws BadInput with the line when it is not JSON. The value must outlive what
  // is reached from it.
  static nlohmann::json parse(std::string_view text, const std::string& file);
  JsonValue(const nlohmann::json& value, std::string file)
      : value_(&value), file_(std::move(file)) {}

  const nlohmann::json& raw() const { return *value_; }
  std::string where() const { return path_.empty() ? file_ : file_ + ": " + path_; }
  [[noreturn]] void fail(const std::string& message) const;

  bool has(std::string_view key) const;
  JsonValue operator[](std::string_view key) const;  // required member of an object
  std::vector<JsonValue> items() const;              // of an array

  bool boolean() const;
  std::string text() const;
  double number() const;                           // finite
  double positive() const;                         // finite and > 0
  double at_least_zero() const;                    // finite and >= 0
  int integer(int least) const;                    // >= least
  int index(int size, std::string_view of) const;  // in [0, size); `of` names what it counts
  Eigen::Vector3d point() const;
  Eigen::Matrix3Xd points() const;
  Eigen::VectorXd numbers() const;

 private:
  JsonValue(const nlohmann::json& value, std::string file, std::string path)
      : value_(&value), file_(std::move(file)), path_(std::move(path)) {}
  [[noreturn]] void expected(const std::string& what) const;

  const nlohmann::json* value_;
  std::string file_;
  std::string path_;
};

}  // namespace tencer::io
