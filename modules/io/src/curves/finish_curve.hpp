// What every curve format has in common: from listed points to a checked polyline.
#pragma once

#include <Eigen/Core>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <tencer/geometry/polyline.hpp>
#include <tencer/io/curve.hpp>
#include <vector>

namespace tencer::io {

// A finite number, or BadInput.
double coordinate(std::string_view field, const std::string& where);

struct ListedCurve {
  std::vector<Eigen::Vector3d> points;
  std::optional<bool> closed;                // when the file says so
  std::string where;                         // of the curve as a whole
  std::function<std::string(int)> where_of;  // of a point
  std::function<std::string(int)> name_of;   // "vertex 12", as the file numbers it
};

// Throws BadInput where points that were computed overflowed.
void check_drawn(const ListedCurve& curve);

// Adds the curve to the file, with its notes. Throws BadInput for what curve.hpp calls an error.
void finish_curve(const ListedCurve& curve, CurveFile& file);

// An edge that no elastic rod can follow: one of no length, or one that turns straight back along
// the edge before it.
struct BadEdge {
  bool no_length = false;  // else straight back
  int from = 0;            // its vertices
  int to = 0;
};
std::optional<BadEdge> bad_edge(const geometry::Polyline& curve);

}  // namespace tencer::io
