#include "design/design_parts.hpp"

#include "curves/finish_curve.hpp"
#include "text/text.hpp"

namespace tencer::io {
namespace {

// Other programs may add up the rest lengths in another order.
constexpr double arc_slack = 1e-9;

}  // namespace

void check_count(const JsonValue& value, long found, long expected, const std::string& what) {
  if (found != expected)
    value.fail("expected " + std::to_string(expected) + " " + what + ", found " +
               std::to_string(found));
}

Eigen::Matrix3Xd read_shape(const JsonValue& value, bool closed) {
  Eigen::Matrix3Xd points = value.points();
  const int least = closed ? 3 : 2;
  if (points.cols() < least)
    value.fail("expected at least " + std::to_string(least) + " points, found " +
               std::to_string(points.cols()));
  if (const auto bad = bad_edge({points, closed}))
    value.items()[bad->from].fail(bad->no_length
                                      ? "zero-length edge: the next point is the same"
                                      : "the rod turns straight back here, which none can follow");
  return points;
}

double read_arc_length(const JsonValue& value, const der::Rod& rod) {
  const double s = value["s"].at_least_zero();
  if (s > rod.length() * (1.0 + arc_slack))
    value["s"].fail("expected an arc length from 0 to " + to_text(rod.length()) + ", found " +
                    to_text(s));
  return s;
}

springs::End read_end(const JsonValue& value, const model::Structure& structure) {
  if (value.has("rod") == value.has("anchor"))
    value.fail("expected {\"rod\", \"s\"} or {\"anchor\"}");
  if (value.has("anchor"))
    return springs::AtAnchor{
        value["anchor"].index(static_cast<int>(structure.anchors.cols()), "anchor")};
  const int rod = value["rod"].index(static_cast<int>(structure.rods.size()), "rod");
  return springs::OnRod{rod, read_arc_length(value, structure.rods[rod])};
}

}  // namespace tencer::io
