#include "alexander.hpp"

#include <algorithm>
#include <cstdint>
#include <utility>

namespace tencer::fabricate {
namespace {

constexpr std::int64_t prime = 2147483647;  // 2^31 - 1
constexpr std::int64_t place = 7;           // a primitive root: its powers repeat only after all

std::int64_t modulo(std::int64_t value) { return (value % prime + prime) % prime; }

std::int64_t inverse(std::int64_t value) {
  std::int64_t result = 1;
  for (std::int64_t exponent = prime - 2; exponent > 0; exponent /= 2) {
    if (exponent % 2 == 1) result = result * value % prime;
    value = value * value % prime;
  }
  return result;
}

using Matrix = std::vector<std::vector<std::int64_t>>;

std::int64_t determinant(Matrix rows) {
  std::int64_t result = 1;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const auto pivot = std::find_if(rows.begin() + static_cast<std::ptrdiff_t>(i), rows.end(),
                                    [&](const auto& row) { return row[i] != 0; });
    if (pivot == rows.end()) return 0;
    if (pivot != rows.begin() + static_cast<std::ptrdiff_t>(i)) {
      std::swap(*pivot, rows[i]);
      result = modulo(-result);
    }
    result = result * rows[i][i] % prime;
    const std::int64_t scale = inverse(rows[i][i]);
    for (std::size_t j = i + 1; j < rows.size(); ++j) {
      const std::int64_t factor = rows[j][i] * scale % prime;
      if (factor == 0) continue;
      for (std::size_t k = i; k < rows.size(); ++k)
        rows[j][k] = modulo(rows[j][k] - factor * rows[i][k] % prime);
    }
  }
  return result;
}

double position(const geometry::EdgePoint& at) { return at.edge + at.t; }

// One row a crossing, one column an arc between two places where the curve goes under; both less
// the last (Fox's derivatives of Wirtinger's relations).
Matrix alexander_matrix(const std::vector<Crossing>& crossings) {
  const std::size_t n = crossings.size();
  std::vector<double> under;
  for (const Crossing& c : crossings) under.push_back(position(c.under));
  std::ranges::sort(under);
  const auto arc_before = [&](const geometry::EdgePoint& at) {
    return static_cast<std::size_t>(std::ranges::lower_bound(under, position(at)) - under.begin()) %
           n;
  };
  Matrix matrix(n, std::vector<std::int64_t>(n, 0));
  for (std::size_t i = 0; i < n; ++i) {
    const Crossing& c = crossings[i];
    const std::size_t in = arc_before(c.under);
    const std::size_t out = (in + 1) % n;
    matrix[i][arc_before(c.over)] += 1 - place;
    matrix[i][c.sine > 0 ? in : out] += place;
    matrix[i][c.sine > 0 ? out : in] -= 1;
  }
  matrix.pop_back();
  for (auto& row : matrix) {
    row.pop_back();
    for (std::int64_t& entry : row) entry = modulo(entry);
  }
  return matrix;
}

}  // namespace

bool knotted(const std::vector<Crossing>& crossings) {
  if (crossings.size() < 3) return false;
  const std::int64_t value = determinant(alexander_matrix(crossings));
  // A ring's is a power of the place, or minus one.
  std::int64_t power = 1;
  for (std::size_t k = 0; k <= crossings.size(); ++k) {
    if (value == power || value == prime - power) return false;
    power = power * place % prime;
  }
  return true;
}

}  // namespace tencer::fabricate
