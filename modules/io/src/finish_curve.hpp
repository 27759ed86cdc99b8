// What every curve format has in common: from listed points to a checked polyline.
#pragma once

#include <Eigen/Core>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <tencer/geometry/polyline.hpp>
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

// Throws BadInput for what curve.hpp calls an error.
geometry::Polyline finish_curve(const ListedCurve& curve);

}  // namespace tencer::io
