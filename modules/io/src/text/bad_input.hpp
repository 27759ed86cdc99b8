// Inside this module's readers bad input is an exception, so that a reader of a nested file stays
// readable; `guarded` turns it into the Error of the public functions. It never leaves the module.
#pragma once

#include <optional>
#include <string>
#include <tencer/core/error.hpp>
#include <utility>

namespace tencer::io {

struct BadInput {
  core::Error error;
};

[[noreturn]] inline void fail(std::string where, std::string message) {
  throw BadInput{{std::move(where), std::move(message)}};
}

// read() as an Expected.
template <class Read>
auto guarded(Read&& read) -> core::Expected<decltype(read())> {
  try {
    return read();
  } catch (BadInput& bad) {
    return std::move(bad.error);
  }
}

// The value of an Expected, or its error thrown on.
template <class T>
T value_or_fail(core::Expected<T> expected) {
  if (!expected) throw BadInput{expected.error()};
  return std::move(expected).value();
}

}  // namespace tencer::io
