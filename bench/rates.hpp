// What one core of this machine can do at most, measured: the rates behind physical floors.
#pragma once

#include <cstddef>

namespace bench {

// Multiplications and additions a second, of independent ones on numbers in registers.
double flop_rate();

// Bytes a second, read again and again from an array of so many bytes: from a cache, or from memory
// when no cache holds it.
double read_rate(std::size_t bytes);

}  // namespace bench
