#pragma once

#include <catch2/catch.hpp>
#include <cmath>

namespace tencer {

// The error of n edges, and of twice as many: the last is small, and it falls with their square.
template <class Error>
void check_second_order(const Error& error, int n, double small) {
  const double coarse = error(n);
  const double fine = error(2 * n);
  CAPTURE(coarse, fine);
  CHECK(std::abs(fine) < small);
  CHECK(coarse / fine == Approx(4.0).epsilon(0.1));
}

}  // namespace tencer
