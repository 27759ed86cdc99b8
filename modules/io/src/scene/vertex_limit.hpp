// How many vertices the rods of a scene may have altogether: far more than a design takes, and as
// many as can be looked at for crossings in a second.
#pragma once

#include <string>
#include <tencer/geometry/polyline.hpp>
#include <vector>

namespace tencer::io {

inline constexpr int most_vertices = 20'000;

// Curves of a file that have more are given so many, evenly along each; a note says so. Throws
// BadInput where there are too many curves for that.
void limit_vertices(std::vector<geometry::Polyline>& curves, const std::string& file,
                    std::vector<std::string>& notes);

}  // namespace tencer::io
