#include <iostream>
#include <tencer/geometry/arc_length.hpp>
#include <tencer/geometry/polyline.hpp>

int main() {
  using namespace tencer::geometry;
  Polyline square{.points = Eigen::Matrix3Xd(3, 4), .closed = true};
  square.points << 0, 1, 1, 0, 0, 0, 1, 1, 0, 0, 0, 0;
  const ArcLength along(edge_lengths(square), square.closed);
  const auto [edge, t] = along.locate(5.25);  // beyond the seam of a curve that is 4 long
  std::cout << "edge " << edge << " at " << t << " of it\n";
  return edge == 1 && t == 0.25 ? 0 : 1;
}
