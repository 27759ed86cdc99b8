// Bad input as a value: Expected<T> holds a T or an Error that names where and what.
#pragma once

#include <stdexcept>
#include <string>
#include <utility>
#include <variant>

namespace tencer::core {

// What is wrong with an input and where. `where` is a place a person can go to: "scene.toml:12",
// "curve.obj:7", "scene.toml: rods[0].EA". `message` says what is wrong and what would be right.
struct [[nodiscard]] Error {
  std::string where;
  std::string message;

  std::string text() const { return where.empty() ? message : where + ": " + message; }
};

// A value or the Error that prevented it; not to be dropped unseen. Reading the one that is not
// there is a caller's mistake and throws std::bad_variant_access.
template <class T>
class [[nodiscard]] Expected {
 public:
  Expected(T value) : content_(std::move(value)) {}
  Expected(Error error) : content_(std::move(error)) {}

  [[nodiscard]] bool has_value() const { return std::holds_alternative<T>(content_); }
  explicit operator bool() const { return has_value(); }

  const T& value() const& { return std::get<T>(content_); }
  T& value() & { return std::get<T>(content_); }
  T&& value() && { return std::get<T>(std::move(content_)); }
  const T& operator*() const& { return value(); }
  T& operator*() & { return value(); }
  T&& operator*() && { return std::move(*this).value(); }
  const T* operator->() const { return &value(); }
  T* operator->() { return &value(); }
  const Error& error() const { return std::get<Error>(content_); }

 private:
  std::variant<T, Error> content_;
};

// A public function's precondition. Throws std::invalid_argument: the caller's code is wrong.
inline void require(bool holds, const char* condition) {
  if (!holds) throw std::invalid_argument(condition);
}

}  // namespace tencer::core
