// The prime knots of up to seven crossings, smooth and roomy (figure 16).
#pragma once

#include <span>
#include <string_view>
#include <tencer/geometry/polyline.hpp>
#include <vector>

namespace tencer::curves {

// A knot as the closure of a braid (see braid_closure).
struct KnotBraid {
  std::string_view name;  // Alexander-Briggs notation: "3_1"
  int strands = 0;
  std::vector<int> word;
};

// 3_1, 4_1, 5_1, 5_2, 6_1 to 6_3, 7_1 to 7_7; of a knot that differs from its mirror image, one of
// the two.
std::vector<KnotBraid> knot_table();

// The closed braid, pushed apart by its tangent-point energy (see repel) and laid out again at
// equal arc length along a smooth curve of this length. Takes up to a second. Throws
// std::invalid_argument unless length > 0 and vertices >= 3, and for what braid_closure refuses.
geometry::Polyline knot(const KnotBraid& braid, double length, int vertices);

}  // namespace tencer::curves
