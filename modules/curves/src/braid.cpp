#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <numbers>
#include <tencer/core/error.hpp>
#include <tencer/curves/braid.hpp>
#include <vector>

namespace tencer::curves {

using geometry::Polyline;

namespace {

using std::numbers::pi;

// Points of a strand on its way past one letter of the word.
constexpr int points_per_letter = 12;

// Radii are in distances of strands. The sectors in which strands cross are half as long again as
// they are wide, also on the innermost strand.
double inner_radius(int letters) { return std::max(1.0, 1.5 * letters / (2 * pi)); }

}  // namespace

Polyline braid_closure(int strands, std::span<const int> word) {
  core::require(strands >= 2 && !word.empty(), "braid_closure: needs two strands and a letter");
  for (const int letter : word)
    core::require(letter != 0 && std::abs(letter) < strands,
                  "braid_closure: a letter names no pair of strands");
  const int letters = static_cast<int>(word.size());
  std::vector<Eigen::Vector3d> points;
  int place = 1;
  int turns = 0;
  do {
    for (int i = 0; i < letters; ++i) {
      const int low = std::abs(word[i]);
      const int move = place == low ? 1 : place == low + 1 ? -1 : 0;
      const double height = 0.5 * move * (word[i] > 0 ? 1 : -1);
      for (int k = 0; k < points_per_letter; ++k) {
        const double t = static_cast<double>(k) / points_per_letter;
        const double radius = inner_radius(letters) + place - 1 + move * (1 - std::cos(pi * t)) / 2;
        const double angle = 2 * pi * (i + t) / letters;
        points.emplace_back(radius * std::cos(angle), radius * std::sin(angle),
                            height * std::sin(pi * t));
      }
      place += move;
    }
    ++turns;
  } while (place != 1);
  core::require(turns == strands, "braid_closure: the closure is more than one curve");
  Polyline curve{Eigen::Matrix3Xd(3, points.size()), true};
  for (std::size_t i = 0; i < points.size(); ++i)
    curve.points.col(static_cast<Eigen::Index>(i)) = points[i];
  return curve;
}

}  // namespace tencer::curves
