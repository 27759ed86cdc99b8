#include <iostream>
#include <tencer/curves/analytic.hpp>
#include <tencer/ground_structure/candidates.hpp>
#include <tencer/ground_structure/dense_springs.hpp>
#include <tencer/model/scaling.hpp>
#include <tencer/model/scene.hpp>
#include <tencer/sparsify/greedy.hpp>

int main() {
  using namespace tencer;
  const model::Scene scene = model::scene_of({curves::ellipse(20, 10, 24)});
  const auto scaling = model::scaling_of(scene.structure, scene.target.points);
  network::Network dense{.structure = model::scaled(scene.structure, scaling)};
  const auto points = model::scaled(scene.target.points, scaling);
  dense.state = model::make_state(dense.structure, points);
  dense.structure.cables = ground_structure::dense_springs(
      dense.structure, points, ground_structure::candidates(dense.structure, points, {}).value());
  const auto target = model::make_target(dense.structure, points);
  const auto pruned = sparsify::prune(dense, target);
  const auto few = sparsify::remove_greedily(pruned.network, target, {.threshold = 1e-4});
  std::cout << network::cable_count(dense) << " springs, " << network::cable_count(pruned.network)
            << " that pull, " << network::cable_count(few.network) << " are enough\n";
  return few.valid() ? 0 : 1;
}
