#include <iostream>
#include <tencer/curves/families.hpp>
#include <tencer/geometry/polyline.hpp>

int main() {
  using namespace tencer;
  for (const curves::Family& family : curves::families()) {
    if (family.name != "circle") continue;
    const auto circle = curves::family_curves(family, std::vector<double>{25}, 100).front();
    std::cout << circle.vertices() << " vertices, " << geometry::edge_lengths(circle).sum()
              << " long\n";
    return circle.closed ? 0 : 1;
  }
  return 1;
}
