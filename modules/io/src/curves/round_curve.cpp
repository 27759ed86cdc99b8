#include "curves/round_curve.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <sstream>
#include <tencer/core/words.hpp>
#include <tencer/geometry/rounding.hpp>
#include <tencer/geometry/sampling.hpp>

#include "scene/vertex_limit.hpp"

namespace tencer::io {
namespace {

// "at arc length 12 cm, (1, 2, 3)"
std::string place_of(const geometry::Corner& corner, const geometry::Polyline& curve,
                     std::string_view length_unit) {
  const auto point = curve.points.col(corner.vertex);
  std::ostringstream text;
  text.precision(3);
  text << "at arc length " << corner.s << ' ' << length_unit << ", (" << point[0] << ", "
       << point[1] << ", " << point[2] << ')';
  return text.str();
}

int enough_vertices(const geometry::Polyline& curve, double radius) {
  constexpr double turn = 1.0 / 3;  // from one edge to the next
  const double needed = std::ceil(geometry::edge_lengths(curve).sum() / (turn * radius));
  return static_cast<int>(std::min<double>(needed, most_vertices));
}

}  // namespace

std::optional<std::string> round_curve(double radius, std::optional<int> vertices,
                                       std::string_view length_unit, geometry::Polyline& curve,
                                       std::vector<std::string>& notes) {
  const geometry::Rounded found = geometry::rounded(curve, radius);
  std::ostringstream text;
  text.precision(3);
  if (found.no_room) {
    text << "there is no room for a radius of " << radius << ' ' << length_unit << ' '
         << place_of(*found.no_room, curve, length_unit) << ", where the curve turns by "
         << found.no_room->angle * 180 / std::numbers::pi
         << " degrees; take a smaller one, or draw the curve rounder there";
    return text.str();
  }
  if (found.bends.empty()) return std::nullopt;
  const std::size_t count = found.bends.size();
  text << core::counted(static_cast<int>(count), "bend") << " sharper than a radius of " << radius
       << ' ' << length_unit << (count == 1 ? " is" : " are")
       << " rounded, which moves the curve by up to " << found.largest_move << ' ' << length_unit
       << ": " << place_of(found.bends.front(), curve, length_unit);
  if (count > 1) text << ", and " << count - 1 << " more";
  text << "; errors count from the rounded curve";
  notes.push_back(text.str());
  const int least = std::max(curve.vertices(), enough_vertices(found.curve, radius));
  curve = geometry::resample(found.curve, vertices.value_or(std::min(least, most_vertices)));
  return std::nullopt;
}

}  // namespace tencer::io
