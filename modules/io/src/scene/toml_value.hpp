// A table of a TOML file with the key path that leads to it. Errors are placed by line and name the
// key: "scene.toml:12: design.max_error: expected a positive number, found -1". What was parsed
// without a file has no place, and errors name the key alone.
#pragma once

#include <toml++/toml.h>

#include <Eigen/Core>
#include <initializer_list>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace tencer::io {

class TomlTable {
 public:
  // The whole file, or with an empty name what is in none; throws BadInput with the line when it is
  // not TOML. The table must outlive what is reached from it.
  static toml::table parse(std::string_view text, const std::string& file);
  explicit TomlTable(const toml::table& table) : table_(&table) {}

  std::string where() const { return where_of(*table_); }
  std::string where(std::string_view key) const;  // of the key's value, if there
  [[noreturn]] void fail(std::string_view key, const std::string& message) const;

  // Refuses keys that are not among these.
  void only(std::span<const std::string_view> keys) const;
  void only(std::initializer_list<std::string_view> keys) const {
    only(std::span<const std::string_view>(keys.begin(), keys.size()));
  }
  std::vector<std::string> keys() const;  // in order of the alphabet
  bool has(std::string_view key) const { return table_->contains(key); }
  bool is_array(std::string_view key) const;
  bool is_array_of_arrays(std::string_view key) const;  // going by the first of them
  bool is_array_of_tables(std::string_view key) const;  // likewise
  bool is_text(std::string_view key) const;

  // Each fails when the key is there with another type or out of its range.
  std::optional<bool> boolean(std::string_view key) const;
  std::optional<std::string> text(std::string_view key) const;
  std::optional<std::string> one_of(std::string_view key,
                                    std::span<const std::string_view> choices) const;
  std::optional<double> number(std::string_view key) const;         // finite
  std::optional<double> positive(std::string_view key) const;       // finite, > 0
  std::optional<double> at_least_zero(std::string_view key) const;  // finite, >= 0
  std::optional<int> integer(std::string_view key, int least,
                             int most = std::numeric_limits<int>::max()) const;
  std::optional<std::vector<double>> numbers(std::string_view key) const;
  std::optional<std::vector<int>> integers(std::string_view key) const;
  std::optional<Eigen::Vector3d> point(std::string_view key) const;
  std::optional<Eigen::Matrix3Xd> points(std::string_view key) const;
  std::optional<TomlTable> table(std::string_view key) const;
  std::vector<TomlTable> tables(std::string_view key) const;  // none when the key is not there
  // Lists of lists of integers, such as [[0, 1], [1, 2]].
  std::optional<std::vector<std::vector<int>>> integer_lists(std::string_view key) const;

  // For a key that must be there.
  template <class T>
  T need(std::string_view key, std::optional<T> value) const {
    if (!value) fail_missing(key);
    return *std::move(value);
  }

 private:
  TomlTable(const toml::table& table, std::string path) : table_(&table), path_(std::move(path)) {}

  static std::string place(const toml::source_region& source);
  std::string where_of(const toml::node& node) const;
  std::string path_to(std::string_view key) const;
  [[noreturn]] void fail_missing(std::string_view key) const;
  [[noreturn]] void expected(const toml::node& node, const std::string& path,
                             const std::string& what) const;
  Eigen::Vector3d point(const toml::node& node, const std::string& path) const;
  double finite(const toml::node& node, const std::string& path) const;
  int integer(const toml::node& node, const std::string& path) const;
  const toml::array* array(std::string_view key, const std::string& what) const;

  const toml::table* table_;
  std::string path_;
};

}  // namespace tencer::io
