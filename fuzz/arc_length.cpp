// Positions along a curve: any s, however large or small, lands on the curve, and going once around
// a closed curve leads back to the same place.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>
#include <tencer/geometry/arc_length.hpp>

#include "must.hpp"

using tencer::fuzz::must;

// Input: one byte closed or open, a double s, then up to 64 doubles as edge lengths.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  constexpr std::size_t head = 1 + sizeof(double);
  if (size < head + 3 * sizeof(double)) return 0;
  const bool closed = (data[0] & 1) != 0;
  double s = 0.0;
  std::memcpy(&s, data + 1, sizeof s);
  const std::size_t edges = std::min<std::size_t>((size - head) / sizeof(double), 64);
  std::array<double, 64> raw{};
  std::memcpy(raw.data(), data + head, edges * sizeof(double));
  Eigen::VectorXd lengths(static_cast<Eigen::Index>(edges));
  for (std::size_t e = 0; e < edges; ++e) {
    // Any mantissa with an exponent a scene could have; zero and NaN break the precondition.
    int exponent = 0;
    const double mantissa = std::frexp(std::abs(raw[e]), &exponent);
    if (!(mantissa > 0.0 && mantissa < 1.0)) return 0;
    const double length = std::ldexp(mantissa, exponent % 20);
    lengths[static_cast<Eigen::Index>(e)] = length;
  }
  if (!std::isfinite(s)) return 0;

  const tencer::geometry::ArcLength arc(lengths, closed);
  const double wrapped = arc.wrap(s);
  must(wrapped >= 0.0);
  must(closed ? wrapped < arc.length() : wrapped <= arc.length());
  must(arc.wrap(wrapped) == wrapped);
  for (const auto side : {tencer::geometry::Side::after, tencer::geometry::Side::before}) {
    const auto at = arc.locate(s, side);
    must(at.edge >= 0 && at.edge < arc.edges());
    must(at.t >= 0.0 && at.t <= 1.0);
    // The place found is the place asked for; s = 0 seen from before is the end of the last edge.
    const double found = arc.knots()[at.edge] + at.t * arc.edge_length(at.edge);
    const double miss = std::abs(found - wrapped);
    const double rounding = 8.0 * std::numeric_limits<double>::epsilon() * arc.length();
    must(miss <= rounding || (closed && std::abs(miss - arc.length()) <= rounding));
  }
  return 0;
}
