// Errors as Python knows them, with the same words.
#pragma once

#include <tencer/core/error.hpp>
#include <utility>

namespace tencer::python {

// Bad input, which is tencer.Error in Python: a ValueError with `where` and `message`.
struct BadInput {
  core::Error error;
};

template <class T>
T value_or_raise(core::Expected<T> expected) {
  if (!expected) throw BadInput{expected.error()};
  return std::move(expected).value();
}

}  // namespace tencer::python
