#include <iostream>
#include <tencer/random_targets/random_knot.hpp>

int main() {
  using namespace tencer::random_targets;
  const auto knot = random_knot({.cables = 6, .length = 100, .vertices = 60, .seed = 7});
  if (!knot) return 1;
  std::cout << knot->curve.vertices() << " vertices, held by " << knot->cables.size()
            << " springs\n";
  return knot->curve.closed ? 0 : 1;
}
